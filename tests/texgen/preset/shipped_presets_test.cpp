// SPDX-License-Identifier: Apache-2.0

#include "texgen/preset/shipped_presets.h"

#include "tests/support/test_files.h"
#include "tests/texgen/preset/rejection.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

namespace foam::texgen {
namespace {

TEST(ShippedPresets, AreFoundByTheirNames) {
    EXPECT_EQ(find_shipped_preset("sea_foam").name, "sea_foam");
    EXPECT_NE(find_shipped_preset("sea_foam").toml.find("[foam]"), std::string_view::npos);
    EXPECT_NE(test::rejection_of([] { find_shipped_preset("sea_fom"); }).find("'sea_foam'"),
              std::string::npos);
}

TEST(ShippedPresets, AreInTheReadmeWithTheirPictures) {
    std::ifstream file(foam::test::readme());
    const std::string readme{std::istreambuf_iterator<char>(file), {}};
    for (const ShippedPreset& preset : shipped_presets()) {
        EXPECT_NE(readme.find(fmt::format("(samples/gallery/{}.jpg)", preset.name)),
                  std::string::npos)
            << preset.name;
        EXPECT_NE(readme.find(fmt::format("| `{}`: ", preset.name)), std::string::npos)
            << preset.name;
    }
}

}  // namespace
}  // namespace foam::texgen
