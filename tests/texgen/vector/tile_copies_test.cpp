// SPDX-License-Identifier: Apache-2.0

#include "texgen/vector/tile_copies.h"

#include <gtest/gtest.h>

namespace foam::texgen {
namespace {

const Page kPage{10.0, 8.0, 1.0, 1.0, Vec2(0.0, 0.0), {10.0, 8.0, 0.0}};

TEST(TileCopies, AnArcInTheMiddleHasOneCopy) {
    const auto copies = copies_near_tile({{4.0, 4.0}, {5.0, 5.0}, 0.2}, kPage, 1.0);
    ASSERT_EQ(copies.size(), 1U);
    EXPECT_EQ(copies[0].offset, LatticeOffset{});
    EXPECT_TRUE(parts_beyond_tile({{4.0, 4.0}, {5.0, 5.0}, 0.2}, kPage, 1.0).empty());
}

// A line that crosses the right border reaches 1 beyond it; its copy begins 1 left of the tile.
TEST(TileCopies, ALineAcrossABorderHasTwoCopiesAndTwoPartsBeyond) {
    const DrawnArc line{{9.0, 4.0}, {11.0, 4.0}, 0.0};
    EXPECT_EQ(copies_near_tile(line, kPage, 0.5).size(), 2U);
    const auto parts = parts_beyond_tile(line, kPage, 0.5);
    ASSERT_EQ(parts.size(), 2U);
    double length = 0.0;
    for (const DrawnArc& part : parts) {
        EXPECT_TRUE(part.tail.x() >= 10.0 || part.head.x() <= 0.0);
        length += (part.head - part.tail).norm();
    }
    EXPECT_DOUBLE_EQ(length, 2.0);
}

// A line 0.5 below the top is 0.5 below the bottom in the copy of the row below.
TEST(TileCopies, ReachDecidesWhetherACopyIsNear) {
    const DrawnArc line{{4.0, 7.5}, {5.0, 7.5}, 0.0};
    EXPECT_EQ(copies_near_tile(line, kPage, 0.4).size(), 1U);
    EXPECT_EQ(copies_near_tile(line, kPage, 0.6).size(), 2U);
    ASSERT_EQ(parts_beyond_tile(line, kPage, 0.6).size(), 1U);
    EXPECT_DOUBLE_EQ(parts_beyond_tile(line, kPage, 0.6)[0].tail.y(), -0.5);
}

}  // namespace
}  // namespace foam::texgen
