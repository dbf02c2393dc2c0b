// SPDX-License-Identifier: Apache-2.0

#include "texgen/animation/camera.h"

#include "tests/support/sample_foams.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace foam::texgen {
namespace {

const ImageOptions kWide{.width = 400, .height = 200, .maps = {}};

// Returns a frame of one lone bubble: a circle of radius 2 around (3, 1).
Frame circle() {
    return snapshot(test::circles({{0, {3.0, 1.0}, 4.0 * std::numbers::pi}}), 1);
}

// The shorter side of the image determines the scale. With a margin of 10 % on each side, 160 of
// its 200 pixels show the 4 units of the circle.
TEST(Camera, FitsThePatchWithItsMargin) {
    const View view = camera_view(circle(), kWide, {.margin = 0.1});
    EXPECT_NEAR(view.pixels_per_unit, 40.0, 1e-12);
    EXPECT_NEAR((view.center - Vec2(3.0, 1.0)).norm(), 0.0, 1e-12);
    EXPECT_NEAR(camera_view(circle(), kWide, {.margin = 0.0}).pixels_per_unit, 50.0, 1e-12);
}

// Before zoom, the scale is 50 pixels per unit. The position (0.75, 0.25) is 100 pixels right of
// the center of the image and 50 pixels below it: 2 units and 1 unit.
TEST(Camera, ZoomsInOnAPositionInTheFittedImage) {
    const View view =
        camera_view(circle(), kWide, {.zoom = 3.0, .margin = 0.0, .center = {0.75, 0.25}});
    EXPECT_NEAR(view.pixels_per_unit, 150.0, 1e-12);
    EXPECT_NEAR((view.center - Vec2(5.0, 0.0)).norm(), 0.0, 1e-12);
}

// No point of any arc is outside of the image, and some points are on its border. The outer arcs of
// two bubbles turn by more than half a circle, so they extend beyond their ends.
TEST(Camera, SeesHowFarArcsBulge) {
    const Frame frame = snapshot(test::patch_foam(2, 1), 1);
    ASSERT_EQ(frame.bubbles.size(), 2U);
    const View view =
        camera_view(frame, {.width = 100, .height = 100, .maps = {}}, {.margin = 0.0});
    Vec2 low = Vec2::Constant(1e9);
    Vec2 high = -low;
    for (const FilmId film : frame.network.films()) {
        const Vec2& tail = frame.positions[frame.network.tail(forward_side(film))];
        for (int k = 0; k <= 10'000; ++k) {
            const Vec2 at = tail + point_at(frame.arcs[film], 1e-4 * k);
            const Vec2 pixel = view.pixels_per_unit * (at - view.center) + Vec2(50.0, 50.0);
            low = low.cwiseMin(pixel);
            high = high.cwiseMax(pixel);
        }
    }
    EXPECT_NEAR((high - low).maxCoeff(), 100.0, 1e-4);
    EXPECT_NEAR((0.5 * (low + high) - Vec2(50.0, 50.0)).norm(), 0.0, 1e-4);
}

TEST(Camera, IsFiniteWithoutBubbles) {
    const View view = camera_view(snapshot(test::circles({}), 1), kWide, {.zoom = 2.0});
    EXPECT_TRUE(std::isfinite(view.pixels_per_unit));
    EXPECT_TRUE(view.center.allFinite());
}

}  // namespace
}  // namespace foam::texgen
