// SPDX-License-Identifier: Apache-2.0

#include "texgen/pictures/contours.h"

#include <gtest/gtest.h>

#include <cmath>

namespace foam::texgen {
namespace {

double area_of(const std::vector<Vec2>& ring) {
    double twice = 0.0;
    for (std::size_t k = 0; k < ring.size(); ++k) {
        twice += cross(ring[k], ring[(k + 1) % ring.size()]);
    }
    return 0.5 * twice;
}

// The four crossings around a single number of 1 are halfway to its neighbors, which are 0: the
// ring is a square with the diagonals 1.
TEST(Contours, SurroundASingleNumber) {
    Image<float> grid(3, 3, 1);
    grid.pixel(1, 1)[0] = 1.0F;
    const auto rings = contours(grid, 0.5);
    ASSERT_EQ(rings.size(), 1U);
    EXPECT_EQ(rings[0].size(), 4U);
    EXPECT_DOUBLE_EQ(area_of(rings[0]), 0.5);
}

// With numbers of 1 and a level of 1/4, the crossings are 3/4 of the way to the zeros beyond the
// border of the grid. A block of 4 x 4 numbers has sides of 3; the corners of the ring are cut off.
TEST(Contours, CloseBeyondTheBorder) {
    Image<float> grid(4, 4, 1);
    std::ranges::fill(grid.samples(), 1.0F);
    const auto rings = contours(grid, 0.25);
    ASSERT_EQ(rings.size(), 1U);
    EXPECT_DOUBLE_EQ(area_of(rings[0]), 4.5 * 4.5 - 4.0 * 0.5 * 0.75 * 0.75);
}

TEST(Contours, RunClockwiseAroundAHole) {
    Image<float> grid(5, 5, 1);
    std::ranges::fill(grid.samples(), 1.0F);
    grid.pixel(2, 2)[0] = 0.0F;
    const auto rings = contours(grid, 0.5);
    ASSERT_EQ(rings.size(), 2U);
    EXPECT_DOUBLE_EQ(area_of(rings[1]), -0.5);
}

// Two diagonal neighbors are one part if the mean of the square reaches the level, otherwise two.
TEST(Contours, DecideSaddlesByTheMean) {
    Image<float> grid(2, 2, 1);
    grid.pixel(0, 0)[0] = grid.pixel(1, 1)[0] = 1.0F;
    EXPECT_EQ(contours(grid, 0.4).size(), 1U);
    EXPECT_EQ(contours(grid, 0.6).size(), 2U);
}

// A number that equals the level is inside of the region. The two crossings above and below it keep
// a distance from it, so that the ring does not touch itself.
TEST(Contours, DoNotTouchWhereANumberEqualsTheLevel) {
    Image<float> grid(3, 1, 1);
    grid.pixel(0, 0)[0] = grid.pixel(2, 0)[0] = 1.0F;
    grid.pixel(1, 0)[0] = 0.5F;
    const auto rings = contours(grid, 0.5);
    ASSERT_EQ(rings.size(), 1U);
    for (std::size_t a = 0; a < rings[0].size(); ++a) {
        for (std::size_t b = 0; b < a; ++b) {
            EXPECT_GT((rings[0][a] - rings[0][b]).norm(), 0.01);
        }
    }
}

TEST(Contours, AreEmptyBelowTheLevel) {
    EXPECT_TRUE(contours(Image<float>(4, 4, 1), 0.5).empty());
}

}  // namespace
}  // namespace foam::texgen
