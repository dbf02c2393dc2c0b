// SPDX-License-Identifier: Apache-2.0

#include "core/files/input_limits.h"

#include "core/geometry/domain.h"
#include "tests/support/test_files.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

namespace foam {
namespace {

std::string security_page() {
    std::ifstream file(foam::test::readme().parent_path() / "SECURITY.md");
    return {std::istreambuf_iterator<char>(file), {}};
}

void expect_row(const std::string& limit, const std::string& value) {
    const std::string row = "\n| " + limit + " | " + value + " |\n";
    EXPECT_NE(security_page().find(row), std::string::npos) << row;
}

std::string mebibytes(std::uint64_t bytes) {
    return std::to_string(bytes / kMebibyte) + " MiB";
}

TEST(InputLimits, AreThoseOfTheSecurityPage) {
    for (const InputKind& kind : kInputKinds) {
        expect_row("size of " + std::string(kind.name), mebibytes(kind.max_bytes));
    }
    expect_row("uncompressed content of a state", mebibytes(kMaxStateContent));
    expect_row("pixels of an image", std::to_string(kMaxImagePixels));
    expect_row("width and height of an image, pixels", std::to_string(kMaxImageExtent));
    expect_row("identities of bubbles in a cache", "0 to " + std::to_string(kMaxIdentity - 1));
    expect_row("width divided by height of a torus in a file, and height by width",
               std::to_string(static_cast<int>(kMaxAspect)));
}

}  // namespace
}  // namespace foam
