// SPDX-License-Identifier: Apache-2.0

#include "texgen/raster/arcs/patch_boundaries.h"

#include "core/foam/measure.h"
#include "tests/support/sample_foams.h"

#include <gtest/gtest.h>

namespace foam::texgen {
namespace {

// Returns the area on the left of a closed loop, in square pixels.
double area_of(std::span<const ArcLoops::Side> loop) {
    double area = 0.0;
    for (const ArcLoops::Side& side : loop) {
        area +=
            0.5 * cross(side.tail, side.tail + side.arc.chord) + segment_area(film_arc(side.arc));
    }
    return area;
}

void expect_closed(const ArcLoops& loops) {
    for (std::size_t k = 0; k < loops.loop_ends.size(); ++k) {
        const std::span<const ArcLoops::Side> loop = loops.loop(k);
        for (std::size_t side = 0; side < loop.size(); ++side) {
            const Vec2 head = loop[side].tail + loop[side].arc.chord;
            EXPECT_LT((head - loop[(side + 1) % loop.size()].tail).norm(), 1e-9);
        }
    }
}

// A boundary has its region on its left. The area within the boundaries of a bubble is therefore
// positive. The areas within the boundaries of the ghost add up to minus the area of all bubbles.
TEST(PatchBoundaries, EncloseTheirBubbles) {
    const Frame frame = snapshot(test::patch_foam(20, 3), 1);
    const RasterGrid grid{100, 80, 0, 0, View{{0.3, 0.1}, 7.0}};
    const PixelPatch pixels{frame, grid, 7.0};
    double total = 0.0;
    for (const BubbleId bubble : frame.network.bubbles()) {
        if (bubble == frame.network.ghost()) {
            continue;
        }
        const ArcLoops loops = boundaries_of(pixels, bubble);
        expect_closed(loops);
        ASSERT_EQ(loops.loop_ends.size(), 1U);
        EXPECT_GT(area_of(loops.loop(0)), 0.0);
        total += area_of(loops.loop(0));
    }
    const ArcLoops around = boundaries_of(pixels, frame.network.ghost());
    expect_closed(around);
    double outside = 0.0;
    for (std::size_t k = 0; k < around.loop_ends.size(); ++k) {
        outside += area_of(around.loop(k));
    }
    EXPECT_NEAR(outside, -total, 1e-6 * total);
}

TEST(PatchBoundaries, OfALoneBubbleAreACircle) {
    const LoneBubble lone{0, {1.0, 2.0}, 4.0};
    const Frame frame = snapshot(test::circles({lone}), 1);
    const RasterGrid grid{100, 80, 0, 0, View{{0.0, 0.0}, 5.0}};
    const PixelPatch pixels{frame, grid, 5.0};
    ASSERT_EQ(region_count(frame), frame.network.bubble_slots() + 1);
    const auto circle = id_at<BubbleId>(frame.network.bubble_slots());
    const ArcLoops loops = boundaries_of(pixels, circle);
    expect_closed(loops);
    EXPECT_NEAR(area_of(loops.loop(0)), 25.0 * 4.0, 1e-9);
    const ArcLoops around = boundaries_of(pixels, frame.network.ghost());
    ASSERT_EQ(around.loop_ends.size(), 1U);
    EXPECT_NEAR(area_of(around.loop(0)), -25.0 * 4.0, 1e-9);
}

TEST(PatchBoundaries, ShowOnlyIfTheyReachTheImage) {
    const RasterGrid grid{10, 10, 0, 0, View{}};
    const std::vector<ArcLoops::Side> loop{{{20.0, 5.0}, pixel_arc({{3.0, 0.0}, 0.0})},
                                           {{23.0, 5.0}, pixel_arc({{-3.0, 0.0}, 0.3})}};
    EXPECT_FALSE(may_be_visible(grid, loop));
    EXPECT_FALSE(may_be_visible(grid, {}));
    const std::vector<ArcLoops::Side> near{{{11.0, 5.0}, pixel_arc({{3.0, 0.0}, 0.0})},
                                           {{14.0, 5.0}, pixel_arc({{-3.0, 0.0}, 0.3})}};
    EXPECT_TRUE(may_be_visible(grid, near));  // an arc may reach as far as its length
}

}  // namespace
}  // namespace foam::texgen
