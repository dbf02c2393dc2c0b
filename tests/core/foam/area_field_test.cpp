// SPDX-License-Identifier: Apache-2.0

#include "core/foam/area_field.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

namespace foam {
namespace {

// Bubbles on the left half of the unit square have the area 1, on the right half the area 4.
// The grid has 96 x 48 cells.
AreaField two_halves() {
    std::vector<double> areas;
    for (int cell = 0; cell < 96 * 48; ++cell) {
        areas.push_back(cell % 96 < 48 ? 1.0 : 4.0);
    }
    return {96, 48, std::move(areas)};
}

TEST(AreaField, RejectsWrongGridsAndAreas) {
    EXPECT_THROW(AreaField(0, 1, {}), std::invalid_argument);
    EXPECT_THROW(AreaField(2, 2, {1.0, 1.0, 1.0}), std::invalid_argument);
    EXPECT_THROW(AreaField(1, 1, {0.0}), std::invalid_argument);
    EXPECT_THROW(AreaField(1, 1, {-1.0}), std::invalid_argument);
    EXPECT_THROW(AreaField(1, 1, {std::numeric_limits<double>::quiet_NaN()}),
                 std::invalid_argument);
    EXPECT_THROW(AreaField(1, 1, {std::numeric_limits<double>::infinity()}), std::invalid_argument);
}

TEST(AreaField, HasRowsFromTheBottomAndRepeatsPeriodically) {
    const AreaField field(2, 2, {1.0, 2.0, 3.0, 4.0});
    EXPECT_EQ(field.at({0.2, 0.2}), 1.0);
    EXPECT_EQ(field.at({0.7, 0.2}), 2.0);
    EXPECT_EQ(field.at({0.2, 0.7}), 3.0);
    EXPECT_EQ(field.at({1.7, -0.3}), 4.0);
    EXPECT_EQ(field.at({-1e-300, 0.0}), 2.0);
}

TEST(AreaField, IsStretchedOverARectangle) {
    const AreaField field = two_halves().stretched_over({10.0, 20.0}, {4.0, 2.0});
    EXPECT_EQ(field.at({11.9, 21.0}), 1.0);
    EXPECT_EQ(field.at({12.1, 21.0}), 4.0);
}

// Four of five points are on the left. The standard deviation of their number is 40.
TEST(AreaField, RandomPointsAreAsDenseAsBubbles) {
    const AreaField field = two_halves().stretched_over({0.0, 0.0}, {6.0, 3.0});
    Random random(5);
    int left = 0;
    double highest = 0.0;
    for (int k = 0; k < 10'000; ++k) {
        const Vec2 point = field.random_point(random);
        left += point.x() < 3.0 ? 1 : 0;
        highest = std::max(highest, point.y());
        EXPECT_GE(point.minCoeff(), 0.0);
        EXPECT_LT(point.x(), 6.0);
        EXPECT_LT(point.y(), 3.0);
    }
    EXPECT_NEAR(left, 8000, 200);
    EXPECT_GT(highest, 2.9);
}

// A square of area 4, half of it in each half of the field, covers 2 / 1 + 2 / 4 = 2.5 bubbles.
TEST(AreaField, TheMeanOverAPolygonCountsItsBubbles) {
    const AreaField field = two_halves().stretched_over({0.0, 0.0}, {6.0, 3.0});
    const std::vector<Vec2> square{{2.0, 0.0}, {4.0, 0.0}, {4.0, 2.0}, {2.0, 2.0}};
    EXPECT_NEAR(field.mean_over(square), 4.0 / 2.5, 0.02);
    const std::vector<Vec2> on_the_left{{0.0, 0.0}, {2.0, 0.0}, {1.0, 2.0}};
    EXPECT_NEAR(field.mean_over(on_the_left), 1.0, 1e-12);
}

// The halves of the square weigh 2 x 1 and 2 x 1/16; their centroids are at x = 2.5 and x = 3.5.
TEST(AreaField, TheCentroidIsWeightedByTheSquareOfTheDensity) {
    const AreaField field = two_halves().stretched_over({0.0, 0.0}, {6.0, 3.0});
    const std::vector<Vec2> square{{2.0, 0.0}, {4.0, 0.0}, {4.0, 2.0}, {2.0, 2.0}};
    const Vec2 center = field.centroid_of(square);
    EXPECT_NEAR(center.x(), (2.5 * 16.0 + 3.5) / 17.0, 0.02);
    EXPECT_NEAR(center.y(), 1.0, 0.02);
}

}  // namespace
}  // namespace foam
