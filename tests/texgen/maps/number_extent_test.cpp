// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/number_extent.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace foam::texgen {
namespace {

NumberPixels row_of(std::initializer_list<float> numbers) {
    NumberPixels row{Image<float>(static_cast<int>(numbers.size()), 1, 1), -1.0, 2.0};
    std::ranges::copy(numbers, row.pixels.samples().begin());
    return row;
}

TEST(NumberExtent, CountsNumbersBeyondTheRange) {
    EXPECT_EQ(extent_of(row_of({-1.0F, 0.0F, 2.0F, 1.0F})), (NumberExtent{-1.0, 2.0, 0.0}));
    EXPECT_EQ(extent_of(row_of({-1.5F, 0.0F, 2.5F, 1.0F})), (NumberExtent{-1.5, 2.5, 0.5}));
}

// Half a step of a 16-bit code is 3 / 65535 / 2 = 2.3e-5.
TEST(NumberExtent, RoundingIsNoClipping) {
    EXPECT_EQ(extent_of(row_of({2.00001F})).clipped, 0.0);
    EXPECT_EQ(extent_of(row_of({2.0001F})).clipped, 1.0);
}

TEST(NumberExtent, NumbersThatAreNotFiniteDoNotCount) {
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(extent_of(row_of({kInfinity, nan, -kInfinity, 1.0F})), (NumberExtent{1.0, 1.0, 0.0}));
    EXPECT_EQ(extent_of(row_of({nan})), NumberExtent{});
}

// Two pixels of three channels: (3, 0, 0.5) and (1, -2, 2.5). The range is from -1 to 2.
TEST(NumberExtent, OfSomeChannelsLeavesOutTheOthers) {
    NumberPixels pixels{Image<float>(2, 1, 3), -1.0, 2.0};
    std::ranges::copy(std::vector<float>{3, 0, 0.5, 1, -2, 2.5}, pixels.pixels.samples().begin());
    EXPECT_EQ(extent_of(pixels, std::vector<std::size_t>{0, 2}), (NumberExtent{0.5, 3.0, 0.5}));
    EXPECT_EQ(extent_of(pixels, std::vector<std::size_t>{1}), (NumberExtent{-2.0, 0.0, 0.5}));
}

TEST(NumberExtent, TheExtentOfTwoImagesCoversBoth) {
    EXPECT_EQ(joined({-1.0, 2.0, 0.25}, {0.0, 3.0, 0.125}), (NumberExtent{-1.0, 3.0, 0.25}));
}

}  // namespace
}  // namespace foam::texgen
