// SPDX-License-Identifier: Apache-2.0

#include "texgen/pictures/traced_outlines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

namespace foam::texgen {
namespace {

// Sets the numbers in [left, right) x [bottom, top).
void fill(Image<float>& grid, int left, int bottom, int right, int top, float number) {
    for (int y = bottom; y < top; ++y) {
        for (int x = left; x < right; ++x) {
            grid.pixel(x, y)[0] = number;
        }
    }
}

// Four corners are cut off at half of the spacing, and remain: nothing else of the sides does.
TEST(TracedOutlines, SimplifiesStraightSides) {
    Image<float> grid(120, 120, 1);
    fill(grid, 10, 10, 110, 110, 1.0F);
    const auto parts = traced_outlines(grid, 0.5);
    ASSERT_EQ(parts.size(), 1U);
    EXPECT_LE(parts[0].outer.size(), 9U);
    EXPECT_NEAR(outline_area(parts[0]), 10'000.0, 20.0);
}

TEST(TracedOutlines, KeepsRoundShapesRound) {
    Image<float> grid(201, 201, 1);
    for (int y = 0; y < 201; ++y) {
        for (int x = 0; x < 201; ++x) {
            const double distance = Vec2(x - 100, y - 100).norm();
            grid.pixel(x, y)[0] = static_cast<float>(std::clamp(80.5 - distance, 0.0, 1.0));
        }
    }
    const auto parts = traced_outlines(grid, 0.5);
    ASSERT_EQ(parts.size(), 1U);
    EXPECT_NEAR(outline_area(parts[0]), std::numbers::pi * 80.0 * 80.0, 100.0);
    for (const Vec2& corner : parts[0].outer) {
        EXPECT_NEAR((corner - Vec2(100.0, 100.0)).norm(), 80.0, 0.1);
    }
}

// The largest part comes first. A hole belongs to the smallest part around it.
TEST(TracedOutlines, SortsPartsAndAssignsHoles) {
    Image<float> grid(120, 60, 1);
    fill(grid, 2, 2, 12, 12, 1.0F);    // a small square
    fill(grid, 20, 2, 70, 52, 1.0F);   // a large square,
    fill(grid, 25, 7, 65, 47, 0.0F);   // with a hole,
    fill(grid, 30, 12, 60, 42, 1.0F);  // in which there is a square
    fill(grid, 40, 22, 50, 32, 0.0F);  // with a hole
    const auto parts = traced_outlines(grid, 0.5);
    ASSERT_EQ(parts.size(), 3U);
    EXPECT_EQ(parts[0].holes.size(), 1U);
    EXPECT_EQ(parts[1].holes.size(), 1U);
    EXPECT_TRUE(parts[2].holes.empty());
    EXPECT_NEAR(outline_area(parts[0]), 900.0, 2.0);
    EXPECT_NEAR(outline_area(parts[1]), 800.0, 2.0);
    EXPECT_NEAR(outline_area(parts[2]), 100.0, 1.0);
}

// The specks have 1/10000 of the area of the region.
TEST(TracedOutlines, DropsSpecks) {
    Image<float> grid(130, 120, 1);
    fill(grid, 10, 10, 110, 110, 1.0F);
    grid.pixel(50, 50)[0] = 0.0F;
    grid.pixel(120, 50)[0] = 1.0F;
    const auto parts = traced_outlines(grid, 0.5);
    ASSERT_EQ(parts.size(), 1U);
    EXPECT_TRUE(parts[0].holes.empty());
}

TEST(TracedOutlines, AreEmptyIfTheRegionIsEmpty) {
    EXPECT_TRUE(traced_outlines(Image<float>(10, 10, 1), 0.5).empty());
}

}  // namespace
}  // namespace foam::texgen
