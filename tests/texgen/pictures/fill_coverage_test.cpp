// SPDX-License-Identifier: Apache-2.0

#include "texgen/pictures/fill_coverage.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace foam::texgen {
namespace {

std::vector<Vec2> rectangle(double left, double bottom, double right, double top) {
    return {{left, bottom}, {right, bottom}, {right, top}, {left, top}};
}

double sum_of(const Image<float>& grid) {
    return std::accumulate(grid.samples().begin(), grid.samples().end(), 0.0);
}

TEST(FillCoverage, IsTheAreaWithinEachPixel) {
    const std::vector<FilledShape> shapes = {{{rectangle(0.25, 0.5, 2.5, 2.0)}, false}};
    const Image<float> grid = fill_coverage(shapes, 3, 2);
    EXPECT_FLOAT_EQ(grid.pixel(0, 0)[0], 0.375F);
    EXPECT_FLOAT_EQ(grid.pixel(1, 0)[0], 0.5F);
    EXPECT_FLOAT_EQ(grid.pixel(0, 1)[0], 0.75F);
    EXPECT_FLOAT_EQ(grid.pixel(1, 1)[0], 1.0F);
    EXPECT_FLOAT_EQ(grid.pixel(2, 1)[0], 0.5F);
}

// A square within a square of the same direction is a hole only by the even-odd rule.
TEST(FillCoverage, FollowsTheFillRule) {
    const std::vector<std::vector<Vec2>> rings = {rectangle(0, 0, 4, 4), rectangle(1, 1, 3, 3)};
    EXPECT_NEAR(sum_of(fill_coverage(std::vector<FilledShape>{{rings, true}}, 4, 4)), 12.0, 1e-6);
    EXPECT_NEAR(sum_of(fill_coverage(std::vector<FilledShape>{{rings, false}}, 4, 4)), 16.0, 1e-6);
}

// A clockwise square is filled, too, and a clockwise square in a counter-clockwise one is a hole.
TEST(FillCoverage, CountsWindings) {
    std::vector<Vec2> inner = rectangle(1, 1, 3, 3);
    std::reverse(inner.begin(), inner.end());
    EXPECT_NEAR(sum_of(fill_coverage(std::vector<FilledShape>{{{inner}, false}}, 4, 4)), 4.0, 1e-6);
    const std::vector<FilledShape> both = {{{rectangle(0, 0, 4, 4), inner}, false}};
    EXPECT_NEAR(sum_of(fill_coverage(both, 4, 4)), 12.0, 1e-6);
}

// Two squares of 2 x 2 that overlap in 1 x 2 pixels cover 6 pixels.
TEST(FillCoverage, UnitesShapes) {
    const std::vector<FilledShape> shapes = {{{rectangle(0, 0, 2, 2)}, false},
                                             {{rectangle(1, 0, 3, 2)}, false}};
    EXPECT_NEAR(sum_of(fill_coverage(shapes, 4, 2)), 6.0, 1e-6);
}

}  // namespace
}  // namespace foam::texgen
