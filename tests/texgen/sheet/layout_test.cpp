// SPDX-License-Identifier: Apache-2.0

#include "texgen/sheet/layout.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

namespace foam::texgen {
namespace {

TEST(SheetLayout, CountsRowsAndPixels) {
    const SheetLayout layout{
        .frames = 7, .frame_width = 10, .frame_height = 20, .columns = 3, .gutter = 2};
    EXPECT_EQ(layout.rows(), 3);  // the last row has one frame
    EXPECT_EQ(layout.width(), 3 * 14);
    EXPECT_EQ(layout.height(), 3 * 24);
}

// 48 square frames: 8 x 6 cells have the aspect ratio 4 : 3, 4 x 12 cells 1 : 3. 96 square frames:
// 8 x 12 cells have 2 : 3, 16 x 6 cells 8 : 3. Two frames are equally far from a square side by
// side and one above the other.
TEST(SheetLayout, IsNearASquareByPowersOfTwo) {
    EXPECT_EQ(near_square_columns(1, 64, 64), 1);
    EXPECT_EQ(near_square_columns(2, 64, 64), 2);
    EXPECT_EQ(near_square_columns(16, 64, 64), 4);
    EXPECT_EQ(near_square_columns(48, 64, 64), 8);
    EXPECT_EQ(near_square_columns(96, 64, 64), 8);
    EXPECT_EQ(near_square_columns(64, 128, 32), 4);
    EXPECT_EQ(near_square_columns(64, 32, 128), 16);
}

TEST(SheetLayout, RejectsInvalidLayouts) {
    constexpr int kMax = std::numeric_limits<int>::max();
    EXPECT_NO_THROW(check_layout({.frames = 1, .frame_width = 1'000'000}));
    EXPECT_NO_THROW(check_layout({.frames = 1, .frame_width = 32768, .frame_height = 32768}));
    EXPECT_THROW(check_layout({.frames = 1, .frame_width = 1'000'001}), std::invalid_argument);
    EXPECT_THROW(check_layout({.frames = 1, .frame_width = 32768, .frame_height = 32769}),
                 std::invalid_argument);
    EXPECT_THROW(check_layout({.frames = 4, .frame_width = 32, .columns = 1'000'000}),
                 std::invalid_argument);
    EXPECT_THROW(check_layout({.frames = 2, .frame_width = kMax, .columns = 2}),
                 std::invalid_argument);
    EXPECT_THROW(check_layout({.frames = 2, .frame_height = kMax / 2 + 1}), std::invalid_argument);
    EXPECT_THROW(check_layout({.frames = 0}), std::invalid_argument);
    EXPECT_THROW(check_layout({.columns = 0}), std::invalid_argument);
    EXPECT_THROW(check_layout({.gutter = -1}), std::invalid_argument);
    EXPECT_THROW(check_layout({.gutter = kMax}), std::invalid_argument);
}

}  // namespace
}  // namespace foam::texgen
