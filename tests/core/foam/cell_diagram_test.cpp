// SPDX-License-Identifier: Apache-2.0

#include "core/foam/cell_diagram.h"

#include "core/foam/measure.h"
#include "tests/core/foams.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

namespace foam {
namespace {

using test::is_valid;

// Two courses of bricks, 1 high and `width` wide, on a torus of one brick a course; the upper
// course stands `shift` to the right of the lower one. Each brick meets itself left and right, and
// two copies of the other above and below: six corners, if the joints do not meet.
CellDiagram bricks(double width, double shift) {
    const std::size_t lower = 0;
    const std::size_t upper = 1;
    return {{{{width, 0.0}, lower, {1, 0}},
             {{width, 1.0}, upper, {0, 0}},
             {{shift, 1.0}, upper, {-1, 0}},
             {{0.0, 1.0}, lower, {-1, 0}},
             {{0.0, 0.0}, upper, {-1, -1}},
             {{shift, 0.0}, upper, {0, -1}}},
            {{{width + shift, 1.0}, upper, {1, 0}},
             {{width + shift, 2.0}, lower, {1, 1}},
             {{width, 2.0}, lower, {0, 1}},
             {{shift, 2.0}, upper, {-1, 0}},
             {{shift, 1.0}, lower, {0, 0}},
             {{width, 1.0}, lower, {1, 0}}}};
}

TEST(CellDiagram, BricksMakeAFoam) {
    const Foam foam = foam_from_cells({4.0, 2.0}, bricks(4.0, 1.0));
    ASSERT_TRUE(is_valid(foam.network));
    EXPECT_EQ(foam.network.bubble_count(), 2U);
    EXPECT_EQ(foam.network.film_count(), 6U);
    EXPECT_EQ(foam.network.junction_count(), 4U);
    for (const BubbleId bubble : foam.network.bubbles()) {
        EXPECT_EQ(foam.network.sides(bubble), 6);
        EXPECT_DOUBLE_EQ(foam.target_areas[bubble], 4.0);
        EXPECT_DOUBLE_EQ(polygon_area(foam, bubble), 4.0);
        EXPECT_EQ(foam.pressures[bubble], 0.0);
        EXPECT_EQ(foam.identities[bubble], index_of(bubble));
    }
    EXPECT_EQ(foam.next_identity, 2U);
}

// Joints of height 1 twice, and courses of length 4 twice.
TEST(CellDiagram, BricksHaveTheirFilms) {
    const Foam foam = foam_from_cells({4.0, 2.0}, bricks(4.0, 1.0));
    EXPECT_DOUBLE_EQ(energy(foam), 1.0 + 1.0 + 4.0 + 4.0);
    for (const FilmId film : foam.network.films()) {
        EXPECT_EQ(foam.t1_armed[film], 1);
    }
}

TEST(CellDiagram, JunctionsLieInTheTorusOwnCell) {
    const Foam foam = foam_from_cells({4.0, 2.0}, bricks(4.0, 1.0));
    for (const Vec2& position : foam.positions) {
        EXPECT_GE(position.minCoeff(), 0.0);
        EXPECT_LT(position.x(), 4.0);
        EXPECT_LT(position.y(), 2.0);
    }
}

// Squares in straight rows and columns, the four sides of each towards itself.
TEST(CellDiagram, RejectsACornerOfFourCells) {
    const CellDiagram squares{{{{1.0, 0.0}, 0, {1, 0}},
                               {{1.0, 1.0}, 0, {0, 1}},
                               {{0.0, 1.0}, 0, {-1, 0}},
                               {{0.0, 0.0}, 0, {0, -1}}}};
    EXPECT_THROW(foam_from_cells({1.0, 1.0}, squares), std::runtime_error);
}

TEST(CellDiagram, RejectsASideWithoutACounterpart) {
    CellDiagram cells = bricks(4.0, 1.0);
    cells[0][1].offset = {0, 7};
    EXPECT_THROW(foam_from_cells({4.0, 2.0}, cells), std::runtime_error);
    cells = bricks(4.0, 1.0);
    cells[0][1].across = 0;
    EXPECT_THROW(foam_from_cells({4.0, 2.0}, cells), std::runtime_error);
}

std::vector<CellCorner> cell_with_corners(const std::vector<Vec2>& points) {
    std::vector<CellCorner> cell;
    cell.reserve(points.size());
    for (const Vec2& point : points) {
        cell.push_back({point, 0, {}});
    }
    return cell;
}

TEST(CellDiagram, AreaAndCentroidOfATriangle) {
    const auto triangle = cell_with_corners({{10.0, 20.0}, {16.0, 20.0}, {10.0, 23.0}});
    EXPECT_DOUBLE_EQ(cell_area(triangle), 9.0);
    EXPECT_DOUBLE_EQ(cell_centroid(triangle).x(), 12.0);
    EXPECT_DOUBLE_EQ(cell_centroid(triangle).y(), 21.0);
}

// A unit square on the right half of a 2 x 1 one's top: area 3, center ((2, 1) + (1.5, 1.5 * 1))
// ... weighted by 2 and 1.
TEST(CellDiagram, AreaAndCentroidOfAnL) {
    const auto l =
        cell_with_corners({{0.0, 0.0}, {2.0, 0.0}, {2.0, 2.0}, {1.0, 2.0}, {1.0, 1.0}, {0.0, 1.0}});
    EXPECT_DOUBLE_EQ(cell_area(l), 3.0);
    EXPECT_DOUBLE_EQ(cell_centroid(l).x(), (2.0 * 1.0 + 1.0 * 1.5) / 3.0);
    EXPECT_DOUBLE_EQ(cell_centroid(l).y(), (2.0 * 0.5 + 1.0 * 1.5) / 3.0);
}

}  // namespace
}  // namespace foam
