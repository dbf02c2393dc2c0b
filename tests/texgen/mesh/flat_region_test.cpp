// SPDX-License-Identifier: Apache-2.0

#include "texgen/mesh/flat_region.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>

namespace foam::texgen {
namespace {

Ring square(double low, double high) {
    return {{low, low}, {high, low}, {high, high}, {low, high}};
}

std::vector<Edge> edges_of_all(const std::vector<Ring>& rings, PointTable& points) {
    std::vector<Edge> edges;
    for (const Ring& ring : rings) {
        std::ranges::copy(edges_of(ring, points), std::back_inserter(edges));
    }
    return without_opposites(edges);
}

double area_of(const std::vector<Triangle>& triangles, const PointTable& points) {
    double area = 0.0;
    for (const auto& [a, b, c] : triangles) {
        const double part = 0.5 * cross(points[b] - points[a], points[c] - points[a]);
        EXPECT_GT(part, 0.0);
        area += part;
    }
    return area;
}

TEST(PrintGrid, SinglePrecisionIsExact) {
    for (const double extent : {0.003, 1.0, 100.0, 4096.0, 99'999.0}) {
        const PrintGrid grid(extent);
        EXPECT_LE(grid.step(), extent / (1 << 21)) << extent;
        const Vec2 point = grid(Vec2(0.7 * extent, -extent / 3.0));
        EXPECT_NEAR(point.x(), 0.7 * extent, grid.step());
        EXPECT_EQ(static_cast<double>(static_cast<float>(point.x())), point.x());
        EXPECT_EQ(static_cast<double>(static_cast<float>(point.y())), point.y());
    }
}

TEST(PointTable, APointHasOneIndex) {
    PointTable points{PrintGrid(100.0)};
    const std::uint32_t first = points.index_of({1.5, -2.5});
    EXPECT_EQ(points.index_of({-1.5, 2.5}), first + 1);
    EXPECT_EQ(points.index_of({1.5 + 1e-7, -2.5}), first);
    EXPECT_EQ(points.size(), 2U);
    EXPECT_EQ(points[first], Vec2(1.5, -2.5));
}

TEST(FlatRegion, MayHaveAHoleWithAnIsland) {
    PointTable points{PrintGrid(10.0)};
    Ring hole = square(1.0, 9.0);
    std::ranges::reverse(hole);
    const auto triangles =
        triangles_of(edges_of_all({square(0.0, 10.0), hole, square(4.0, 5.0)}, points), points);
    EXPECT_EQ(area_of(triangles, points), 100.0 - 64.0 + 1.0);
    EXPECT_EQ(points.size(), 12U);
}

// Two squares that cover each other are one region. Two points are added at the crossings.
TEST(FlatRegion, CrossingRingsAreJoined) {
    PointTable points{PrintGrid(10.0)};
    const auto triangles =
        triangles_of(edges_of_all({square(0.0, 4.0), square(3.0, 5.0)}, points), points);
    EXPECT_EQ(area_of(triangles, points), 16.0 + 4.0 - 1.0);
    EXPECT_EQ(points.size(), 10U);
}

// On a grid of step 1, the crossing of the edge from (-3, -1) to (4, 2) with the edge from (1, -3)
// to (0, 1) is rounded to the point (0, 0), whose index is 0.
TEST(FlatRegion, ACrossingMayBeTheFirstPoint) {
    PointTable points{PrintGrid(1 << 22)};
    const std::vector<Edge> edges = edges_of_all({{{0, 0}, {-20, 2}, {-20, -2}},
                                                  {{-3, -1}, {4, 2}, {-3, 30}},
                                                  {{1, -3}, {0, 1}, {-1, 1}, {30, -40}}},
                                                 points);
    EXPECT_FALSE(triangles_of(edges, points).empty());
}

// On a grid of step 1, the edge from (11, 0) to (5, 1) crosses the side of the square at (10, 1/6),
// which is rounded to the corner (10, 0). The edge from (5, 1) to (11, -4) crosses the lower side
// at (6.2, 0), which is rounded to (6, 0). The triangle (6, 0), (11, -4), (11, 0) is outside.
TEST(FlatRegion, ACrossingMayBeACorner) {
    PointTable points{PrintGrid(1 << 22)};
    const std::vector<Edge> edges =
        edges_of_all({square(0.0, 10.0), {{5, 1}, {11, -4}, {11, 0}}}, points);
    const std::vector<Triangle> triangles = triangles_of(edges, points);
    EXPECT_TRUE(are_distinct(sorted_edges(triangles)));
    EXPECT_EQ(area_of(triangles, points), 100.0 + 0.5 * 5.0 * 4.0);
}

TEST(FlatRegion, ClockwiseRingsAloneAreEmpty) {
    PointTable points{PrintGrid(10.0)};
    Ring ring = square(0.0, 1.0);
    std::ranges::reverse(ring);
    EXPECT_TRUE(triangles_of(edges_of_all({ring}, points), points).empty());
    EXPECT_TRUE(triangles_of({}, points).empty());
}

// Rings that share an edge in opposite directions are one ring.
TEST(FlatRegion, OppositeEdgesVanish) {
    PointTable points{PrintGrid(10.0)};
    const Ring left = square(0.0, 1.0);
    const Ring right = {{1.0, 0.0}, {2.0, 0.0}, {2.0, 1.0}, {1.0, 1.0}};
    const std::vector<Edge> edges = edges_of_all({left, right}, points);
    EXPECT_EQ(edges.size(), 6U);
    EXPECT_EQ(area_of(triangles_of(edges, points), points), 2.0);
    EXPECT_EQ(without_opposites({edge_between(0, 1), edge_between(1, 0), edge_between(0, 1)}),
              (std::vector<Edge>{edge_between(0, 1)}));
}

TEST(FlatRegion, EdgesWithoutLengthAreLeftOut) {
    PointTable points{PrintGrid(10.0)};
    EXPECT_EQ(edges_of({{0.0, 0.0}, {1e-9, 0.0}, {1.0, 0.0}, {0.0, 1.0}}, points).size(), 3U);
}

}  // namespace
}  // namespace foam::texgen
