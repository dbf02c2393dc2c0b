#include "texgen/raster/distance/patch_regions.h"

#include "tests/support/sample_foams.h"

#include <gtest/gtest.h>

#include <cstddef>

namespace foam::texgen {
namespace {

RasterGrid grid_of(int width, int height, const Vec2& center, double scale) {
    return {width, height, 0, 0, View{center, scale}};
}

void expect_closed_loops(const Boundary& boundary) {
    for (std::size_t loop = 0; loop < boundary.loop_ends.size(); ++loop) {
        const auto sides = boundary.loop(loop);
        for (std::size_t k = 0; k < sides.size(); ++k) {
            const DistanceArc& next = sides[(k + 1) % sides.size()];
            EXPECT_EQ(sides[k].to, next.from);
            const double scale = 1.0 + next.tail.norm();
            EXPECT_LT((sides[k].tail + sides[k].shape.chord - next.tail).norm(), 1e-12 * scale);
            EXPECT_LT((sides[k].from / kSubpixel - sides[k].tail).norm(), 1.0 / kSubpixel);
        }
    }
}

TEST(PatchRegions, BeginWithTheSurroundingsAndHaveClosedBoundaries) {
    const Frame frame = snapshot(test::ring_foam(), 1);
    const RasterGrid grid = grid_of(90, 80, {0.0, 0.0}, 16.0);
    const PatchRegions regions(frame, grid, 2);
    ASSERT_EQ(regions.regions().size(), 7U);
    for (std::size_t k = 0; k < 7; ++k) {
        Boundary boundary;
        regions.trace(k, {1024, -2048}, boundary);
        EXPECT_EQ(boundary.loop_ends.size(), k == 0 ? 2U : 1U);  // outside, and the hole
        expect_closed_loops(boundary);
    }
    const Region& around = regions.regions().front();
    EXPECT_EQ(around.kind, RegionKind::Surroundings);
    EXPECT_EQ(around.id, index_of(frame.network.ghost()));
    const PixelBox box = box_around(around, {});
    EXPECT_EQ(box.columns(), 90);
    EXPECT_EQ(box.rows(), 80);
}

TEST(PatchRegions, LeaveOutWhatTheImageDoesNotShow) {
    const Frame frame = snapshot(test::circles({{0, {-2.0, 0.0}, 4.0}, {1, {6.0, 0.0}, 4.0}}), 1);
    const RasterGrid grid = grid_of(40, 40, {-2.0, 0.0}, 10.0);
    const PatchRegions regions(frame, grid, 1);
    ASSERT_EQ(regions.regions().size(), 2U);
    EXPECT_EQ(regions.regions()[1].id, index_of(frame.network.ghost()) + 1);
    EXPECT_EQ(regions.regions()[1].kind, RegionKind::Circle);
}

// So close that positions in subpixels do not fit 32 bits.
TEST(PatchRegions, HaveBoxesInTheImageAtAnyScale) {
    const Frame frame = snapshot(test::patch_foam(12, 3), 1);
    const RasterGrid grid = grid_of(50, 60, {0.3, 0.1}, 1e8);
    const PatchRegions regions(frame, grid, 1);
    EXPECT_GE(regions.regions().size(), 2U);
    for (std::size_t k = 0; k < regions.regions().size(); ++k) {
        const PixelBox box = box_around(regions.regions()[k], {});
        EXPECT_GE(box.left, 0);
        EXPECT_LE(box.right, 50);
        EXPECT_GE(box.bottom, 0);
        EXPECT_LE(box.top, 60);
        Boundary boundary;
        regions.trace(k, {}, boundary);
        expect_closed_loops(boundary);
    }
}

}  // namespace
}  // namespace foam::texgen
