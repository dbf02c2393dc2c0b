// SPDX-License-Identifier: Apache-2.0

#include "core/foam/clipped_cells.h"

#include <gtest/gtest.h>

#include <vector>

namespace foam {
namespace {

constexpr double kClipping = 1e-14;  // rounding errors

std::vector<CellCorner> rectangle_cell(double left, double bottom, double right, double top) {
    return {{{left, bottom}, 0, {}},
            {{right, bottom}, 0, {}},
            {{right, top}, 0, {}},
            {{left, top}, 0, {}}};
}

Outline rectangle(double left, double bottom, double right, double top) {
    return {{{left, bottom}, {right, bottom}, {right, top}, {left, top}}, {}};
}

// Two adjacent squares of side 2 are clipped to a rectangle of 2 x 1 in their middle. A unit square
// of each is left, and the two unit squares share the two points on their common border.
TEST(ClipCells, CutsCellsThatShareABorder) {
    const CellDiagram diagram{rectangle_cell(0, 0, 2, 2), rectangle_cell(2, 0, 4, 2)};
    const ClippedCells clipped = clip_cells(rectangle(1.0, 0.5, 3.0, 1.5), diagram);
    ASSERT_EQ(clipped.mesh.cells.size(), 2U);
    EXPECT_EQ(clipped.mesh.points.size(), 6U);
    for (const PolygonMesh::Cell& cell : clipped.mesh.cells) {
        EXPECT_NEAR(polygon_area(clipped.mesh, cell), 1.0, kClipping);
    }
    ASSERT_EQ(clipped.centers.size(), 2U);
    EXPECT_NEAR((clipped.centers[0] - Vec2(1.5, 1.0)).norm(), 0.0, kClipping);
    EXPECT_NEAR((clipped.centers[1] - Vec2(2.5, 1.0)).norm(), 0.0, kClipping);
}

// A triangle with a corner just left of the common border of two cells. One of its sides crosses
// the border 1.1e-9 away from this corner. That is more than the tolerance of 1e-9, but both points
// are within a square of this side. The cells share the two points on their border.
TEST(ClipCells, KeepsTwoPointsThatAreJustFartherApartThanTheTolerance) {
    constexpr double kBorder = 4e-10;
    const Outline triangle{{{-kBorder, -kBorder}, {0.5, 0.5}, {-0.5, 0.5}}, {}};
    const std::vector<CellCorner> left = rectangle_cell(-1, -1, kBorder, 1);
    const std::vector<CellCorner> right = rectangle_cell(kBorder, -1, 1, 1);
    for (const CellDiagram& diagram : {CellDiagram{left, right}, CellDiagram{right, left}}) {
        const ClippedCells clipped = clip_cells(triangle, diagram);
        ASSERT_EQ(clipped.mesh.cells.size(), 2U);
        EXPECT_EQ(clipped.mesh.points.size(), 5U);
        EXPECT_EQ(clipped.mesh.cells[0].size() + clipped.mesh.cells[1].size(), 7U);
    }
}

// The two cells on both sides of each border compute the same cut with the outline, also if it is
// long and crosses the borders at a small angle.
TEST(ClipCells, MergesTheCutsOfNeighbors) {
    CellDiagram diagram;
    for (int column = 0; column < 300; ++column) {
        diagram.push_back(rectangle_cell(column, 0, column + 1, 1));
        diagram.push_back(rectangle_cell(column, 1, column + 1, 2));
    }
    const Outline triangle{{{0.3, 0.1}, {299.7, 1.1}, {0.4, 1.7}}, {}};
    const PolygonMesh mesh = clip_cells(triangle, diagram).mesh;
    for (std::size_t a = 0; a < mesh.points.size(); ++a) {
        for (std::size_t b = 0; b < a; ++b) {
            EXPECT_GT((mesh.points[a] - mesh.points[b]).norm(), 1e-3);
        }
    }
}

TEST(ClipCells, LeavesNothingOfACellOutsideButItsMiddle) {
    const CellDiagram diagram{rectangle_cell(0, 0, 2, 2)};
    const ClippedCells clipped = clip_cells(rectangle(5.0, 0.0, 6.0, 1.0), diagram);
    EXPECT_TRUE(clipped.mesh.cells.empty());
    ASSERT_EQ(clipped.centers.size(), 1U);
    EXPECT_NEAR((clipped.centers[0] - Vec2(1.0, 1.0)).norm(), 0.0, kClipping);
}

// The outline is a U, whose legs are 1 and 2 wide and cross the cell. Each leg cuts a part out of
// the cell. The center is the centroid of the larger part.
TEST(ClipCells, MakesACellOfEachPart) {
    const CellDiagram diagram{rectangle_cell(0, 2, 6, 3)};
    const Outline u{{{0, 0}, {5, 0}, {5, 4}, {3, 4}, {3, 1}, {1, 1}, {1, 4}, {0, 4}}, {}};
    const ClippedCells clipped = clip_cells(u, diagram);
    ASSERT_EQ(clipped.mesh.cells.size(), 2U);
    EXPECT_NEAR(polygon_area(clipped.mesh, clipped.mesh.cells[0]) +
                    polygon_area(clipped.mesh, clipped.mesh.cells[1]),
                3.0,
                kClipping);
    EXPECT_NEAR((clipped.centers[0] - Vec2(4.0, 2.5)).norm(), 0.0, kClipping);
}

// Returns two unit squares with a strip of width 0.05 between them. The area of the strip is below
// a tenth of the mean area, 0.68.
PolygonMesh squares_with_a_strip_between() {
    return {{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {1.05, 0}, {1.05, 1}, {2.05, 0}, {2.05, 1}},
            {{0, 1, 2, 3}, {1, 4, 5, 2}, {4, 6, 7, 5}}};
}

TEST(MergeSlivers, MergesAStripIntoANeighbor) {
    PolygonMesh mesh = squares_with_a_strip_between();
    merge_slivers(mesh);
    ASSERT_EQ(mesh.cells.size(), 2U);
    EXPECT_NEAR(polygon_area(mesh, mesh.cells[0]), 1.05, 1e-12);
    EXPECT_NEAR(polygon_area(mesh, mesh.cells[1]), 1.0, 1e-12);
}

TEST(MergeSlivers, DropsASliverWithoutNeighbors) {
    PolygonMesh mesh = squares_with_a_strip_between();
    mesh.cells[1] = mesh.cells[2];
    mesh.cells.pop_back();
    mesh.points.insert(mesh.points.end(), {{5.0, 0.0}, {5.1, 0.0}, {5.0, 0.1}});
    mesh.cells.push_back({8, 9, 10});
    merge_slivers(mesh);
    EXPECT_EQ(mesh.cells.size(), 2U);
}

TEST(MergeSlivers, KeepsCellsOfSimilarSize) {
    PolygonMesh mesh{{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {2, 0}, {2, 1}},
                     {{0, 1, 2, 3}, {1, 4, 5, 2}}};
    merge_slivers(mesh);
    EXPECT_EQ(mesh.cells, (std::vector<PolygonMesh::Cell>{{0, 1, 2, 3}, {1, 4, 5, 2}}));
}

}  // namespace
}  // namespace foam
