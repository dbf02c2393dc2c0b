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

// Returns two rows of bricks, 1 high and `width` wide, on a torus with one brick per row. The upper
// row is shifted to the right by `shift`. Each brick is its own neighbor on the left and on the
// right, and touches two copies of the other brick above and below. It has six corners if the
// vertical joints of the two rows do not meet.
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

// The films are two vertical joints of length 1 and two horizontal lines of length 4.
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

// The diagram is a single square, whose sides are its own neighbors on the torus.
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

TEST(CellDiagram, ATriangleHasItsKnownAreaAndCentroid) {
    const auto triangle = cell_with_corners({{10.0, 20.0}, {16.0, 20.0}, {10.0, 23.0}});
    EXPECT_DOUBLE_EQ(cell_area(triangle), 9.0);
    EXPECT_DOUBLE_EQ(polygon_centroid(cell_polygon(triangle)).x(), 12.0);
    EXPECT_DOUBLE_EQ(polygon_centroid(cell_polygon(triangle)).y(), 21.0);
}

// The L consists of a rectangle of 2 x 1 and a unit square on the right half of its top. The
// centroid is the mean of their centers (1, 0.5) and (1.5, 1.5), weighted by the areas 2 and 1.
TEST(CellDiagram, AnLHasItsKnownAreaAndCentroid) {
    const auto l =
        cell_with_corners({{0.0, 0.0}, {2.0, 0.0}, {2.0, 2.0}, {1.0, 2.0}, {1.0, 1.0}, {0.0, 1.0}});
    EXPECT_DOUBLE_EQ(cell_area(l), 3.0);
    EXPECT_DOUBLE_EQ(polygon_centroid(cell_polygon(l)).x(), (2.0 * 1.0 + 1.0 * 1.5) / 3.0);
    EXPECT_DOUBLE_EQ(polygon_centroid(cell_polygon(l)).y(), (2.0 * 0.5 + 1.0 * 1.5) / 3.0);
}

}  // namespace
}  // namespace foam
