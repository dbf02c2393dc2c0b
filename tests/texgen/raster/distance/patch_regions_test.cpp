// SPDX-License-Identifier: Apache-2.0

#include "texgen/raster/distance/patch_regions.h"

#include "tests/support/sample_foams.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
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
    for (const Boundary::Outline& edges : boundary.outline()) {
        for (std::size_t k = 0; k < ArcLanes::kLanes; ++k) {
            const Point from(edges.from_x[k], edges.from_y[k]);
            const Point to(edges.to_x[k], edges.to_y[k]);
            if (from != to) {
                begins.push_back(from);
                ends.push_back(to);
            }
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

}  // namespace
}  // namespace foam::texgen
