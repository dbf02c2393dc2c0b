// SPDX-License-Identifier: Apache-2.0

#include "texgen/preset/nearest.h"

#include <gtest/gtest.h>

#include <array>

namespace foam::texgen {
namespace {

constexpr std::array<std::string_view, 3> kNames = {"sea_foam", "labyrinth", "coarsening"};

TEST(Nearest, FindsTheWordOfATypo) {
    EXPECT_EQ(nearest("sea_foma", kNames), "sea_foam");   // two replacements
    EXPECT_EQ(nearest("labrynth", kNames), "labyrinth");  // one left out, one replaced
    EXPECT_EQ(nearest("coarseningg", kNames), "coarsening");
}

TEST(Nearest, FindsNothingForUnrelatedWords) {
    EXPECT_EQ(nearest("beer", kNames), "");
    EXPECT_EQ(nearest("", kNames), "");
}

TEST(Nearest, TakesTheCloserOfTwo) {
    constexpr std::array<std::string_view, 2> kClose = {"image.size", "image.maps"};
    EXPECT_EQ(nearest("image.map", kClose), "image.maps");
}

}  // namespace
}  // namespace foam::texgen
