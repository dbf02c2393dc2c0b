// SPDX-License-Identifier: Apache-2.0

#include "texgen/verify/normal_maps.h"

#include <gtest/gtest.h>

namespace foam::texgen {
namespace {

TEST(NormalMaps, AreTheMapsOfNormals) {
    EXPECT_EQ(normal_map_names(),
              (std::vector<std::string_view>{"normal", "normal_gl", "normal_dx"}));
    EXPECT_TRUE(is_normal_map("normal_dx"));
    EXPECT_FALSE(is_normal_map("motion"));
    EXPECT_FALSE(is_normal_map(""));
}

}  // namespace
}  // namespace foam::texgen
