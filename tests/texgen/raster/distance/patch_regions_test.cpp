// SPDX-License-Identifier: Apache-2.0

#include "texgen/raster/distance/patch_regions.h"

#include "tests/support/sample_foams.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

namespace foam::texgen {
namespace {

RasterGrid grid_of(int width, int height, const Vec2& center, double scale) {
    return {width, height, 0, 0, View{center, scale}};
}

// Expects that each edge of an outline ends where another edge begins. This is the next edge,
// except at the end of a loop. Returns the number of loops.
int expect_closed_loops(const Boundary& boundary) {
    using Point = std::pair<double, double>;
    std::vector<Point> begins;
    std::vector<Point> ends;
    for (const OutlineArc& edge : boundary.outline()) {
        if (edge.from != edge.to) {
            begins.emplace_back(edge.from.x(), edge.from.y());
            ends.emplace_back(edge.to.x(), edge.to.y());
        }
    }
    int loops = 1;
    for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
        loops += ends[k] == begins[k + 1] ? 0 : 1;
    }
    std::sort(begins.begin(), begins.end());
    std::sort(ends.begin(), ends.end());
    EXPECT_EQ(begins, ends);
    return loops;
}

TEST(PatchRegions, BeginWithTheSurroundingsAndHaveClosedBoundaries) {
    const Frame frame = snapshot(test::ring_foam(), 1);
    const RasterGrid grid = grid_of(90, 80, {0.0, 0.0}, 16.0);
    const std::vector<Region> regions = patch_regions(frame, grid, 2);
    ASSERT_EQ(regions.size(), 7U);
    for (std::size_t k = 0; k < 7; ++k) {
        // The surroundings have two loops: around the ring and in the hole.
        EXPECT_EQ(expect_closed_loops(regions[k].boundary), k == 0 ? 2 : 1);
    }
    const Region& around = regions.front();
    EXPECT_EQ(around.kind, RegionKind::Surroundings);
    EXPECT_EQ(around.id, index_of(frame.network.ghost()));
    const PixelBox box = box_around(around, {});
    EXPECT_EQ(box.columns(), 90);
    EXPECT_EQ(box.rows(), 80);
}

TEST(PatchRegions, LeaveOutBubblesOutsideOfTheImage) {
    const Frame frame = snapshot(test::circles({{0, {-2.0, 0.0}, 4.0}, {1, {6.0, 0.0}, 4.0}}), 1);
    const RasterGrid grid = grid_of(40, 40, {-2.0, 0.0}, 10.0);
    const std::vector<Region> regions = patch_regions(frame, grid, 1);
    ASSERT_EQ(regions.size(), 2U);
    EXPECT_EQ(regions[1].id, index_of(frame.network.ghost()) + 1);
    EXPECT_EQ(regions[1].kind, RegionKind::Circle);
}

// The view is so close that positions in subpixels do not fit in 32 bits.
TEST(PatchRegions, HaveBoxesInTheImageAtAnyScale) {
    const Frame frame = snapshot(test::patch_foam(12, 3), 1);
    const RasterGrid grid = grid_of(50, 60, {0.3, 0.1}, 1e8);
    const std::vector<Region> regions = patch_regions(frame, grid, 1);
    EXPECT_GE(regions.size(), 2U);
    for (const Region& region : regions) {
        const PixelBox box = box_around(region, {});
        EXPECT_GE(box.left, 0);
        EXPECT_LE(box.right, 50);
        EXPECT_GE(box.bottom, 0);
        EXPECT_LE(box.top, 60);
        expect_closed_loops(region.boundary);
    }
}

// Returns an arc with the given radius, in a direction that is not parallel to an axis.
FilmArc arc_of(double radius, double half_angle) {
    const double c = 2.0 * radius * std::sin(std::abs(half_angle));
    return {Vec2(c * std::cos(0.7), c * std::sin(0.7)), half_angle};
}

std::vector<Vec2> chain_of(const FilmArc& arc) {
    std::vector<Vec2> chain{Vec2::Zero()};
    append_chain_points(arc, Vec2::Zero(), chain);
    chain.push_back(arc.chord);
    return chain;
}

double area_left_of_chord(const std::vector<Vec2>& chain) {
    double twice = 0.0;
    for (std::size_t k = 0; k + 1 < chain.size(); ++k) {
        twice += cross(chain[k], chain[k + 1]);
    }
    return 0.5 * twice;
}

// Returns the distances by which the chain is outside of the arc, in pixels, at the middles of n
// equal parts of the arc.
std::vector<double> excess(const FilmArc& arc, int n) {
    const std::vector<Vec2> chain = chain_of(arc);
    const double sign = arc.half_angle > 0.0 ? 1.0 : -1.0;
    const double radius = std::abs(1.0 / curvature(arc));
    const Vec2 center = sign * radius * turned_left(tangent_at_tail(arc));
    std::vector<double> distances;
    std::size_t edge = 0;
    for (int k = 0; k < n; ++k) {
        const Vec2 ray = point_at(arc, (k + 0.5) / n) - center;
        while (edge + 2 < chain.size() && sign * cross(ray, chain[edge + 1] - center) < 0.0) {
            ++edge;
        }
        const Vec2 a = chain[edge] - center;
        const Vec2 d = chain[edge + 1] - chain[edge];
        distances.push_back(radius * (cross(a, d) / cross(ray, d) - 1.0));
    }
    return distances;
}

// Returns the largest area between chain and arc along any part of the arc as long as the diagonal
// of a pixel.
double largest_area_error(const FilmArc& arc) {
    constexpr int kSamples = 4000;
    const std::vector<double> distances = excess(arc, kSamples);
    const double step = arc_length(arc) / kSamples;
    const auto window = static_cast<std::size_t>(std::numbers::sqrt2 / step);
    double area = 0.0;
    double largest = 0.0;
    for (std::size_t k = 0; k < distances.size(); ++k) {
        area += step * distances[k];
        area -= k >= window ? step * distances[k - window] : 0.0;
        largest = std::max(largest, std::abs(area));
    }
    return largest;
}

TEST(ArcChain, DoesNotSplitAStraightArc) {
    std::vector<Vec2> points;
    append_chain_points({Vec2(100.0, 30.0), 0.0}, Vec2::Zero(), points);
    append_chain_points({Vec2(0.0, 0.0), 0.0}, Vec2::Zero(), points);
    append_chain_points({Vec2(0.0, 0.0), 0.5}, Vec2::Zero(), points);
    append_chain_points({Vec2(1.0, 0.0), 1e-6}, Vec2::Zero(), points);
    EXPECT_TRUE(points.empty());
}

TEST(ArcChain, KeepsTheArea) {
    for (const double radius : {1.0, 5.0, 40.0, 300.0}) {
        for (const double half_angle : {-1.4, -0.3, 0.1, 0.8, 1.4, 2.5}) {
            const FilmArc arc = arc_of(radius, half_angle);
            const double tolerance = 1e-4 * arc_length(arc);
            EXPECT_NEAR(area_left_of_chord(chain_of(arc)), segment_area(arc), tolerance)
                << radius << " " << half_angle;
        }
    }
}

TEST(ArcChain, StaysCloseToItsArc) {
    for (const double radius : {1.0, 3.0, 10.0, 30.0, 100.0, 300.0, 1000.0, 5000.0}) {
        for (const double half_angle : {0.003, 0.01, 0.03, 0.1, 0.3, 1.0, 1.4}) {
            EXPECT_LT(largest_area_error(arc_of(radius, half_angle)), 1.5e-3)
                << radius << " " << half_angle;
        }
    }
}

TEST(ArcChain, IsRelativeToTheTail) {
    const FilmArc arc = arc_of(20.0, 0.7);
    std::vector<Vec2> original;
    std::vector<Vec2> moved;
    append_chain_points(arc, Vec2::Zero(), original);
    append_chain_points(arc, Vec2(3.0, -2.0), moved);
    ASSERT_EQ(original.size(), moved.size());
    for (std::size_t k = 0; k < original.size(); ++k) {
        EXPECT_LT((moved[k] - original[k] - Vec2(3.0, -2.0)).norm(), 1e-12);
    }
}

}  // namespace
}  // namespace foam::texgen
