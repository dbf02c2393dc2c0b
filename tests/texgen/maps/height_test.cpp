// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/height.h"

#include "tests/texgen/keys/limits.h"
#include "tests/texgen/maps/lone_circle.h"
#include "tests/texgen/maps/spherical_cap.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace foam::texgen {
namespace {

const ReliefOptions kRelief;
const MazeOptions kMaze;

using test::LoneCircle;

constexpr double kRadius = 25.0;  // pixels

TEST(Height, ALoneBubblesDomeIsACap) {
    LoneCircle circle(kRadius);
    const test::SphericalCap cap{kRadius};
    const NumberPixels height = draw_height(circle.layers, {kRelief, kMaze}, {});
    test::for_each_inside(kRadius, [&](int x, int y, const Vec2& point) {
        EXPECT_NEAR(height.pixels.pixel(x, y)[0], cap.height(point.norm()) / (2 * kRadius), 1e-4);
    });
    EXPECT_EQ(height.pixels.pixel(0, 0)[0], 0.0F);
    EXPECT_EQ(draw_height(circle.layers, {kRelief, kMaze}, {.full = {3.0}}).high, 3.0);
}

// The bubble is the mean bubble, and its diameter is 2 * kRadius pixels. A seeded mean bubble has
// the area 1; here the bubble has the area pi.
TEST(Height, ItsUnitIsADiameterInWidthsOfTheImage) {
    LoneCircle circle(kRadius);
    const double width = circle.layers.grid().width;
    EXPECT_NEAR(height_unit(circle.layers, {.mean_bubble = MeanBubble::Current}),
                2.0 * kRadius / width,
                1e-12);
    EXPECT_NEAR(height_unit(circle.layers, {.mean_bubble = MeanBubble::Seed}),
                2.0 * kRadius / width / std::sqrt(std::numbers::pi),
                1e-12);
}

TEST(Height, LimitsHoldOnBothSides) {
    test::expect_limits(height_keys(), {{"full", "0", "1e-6", "1e6", "1e7"}});
}

}  // namespace
}  // namespace foam::texgen
