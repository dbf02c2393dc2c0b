// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/occlusion.h"

#include "tests/texgen/keys/limits.h"
#include "tests/texgen/maps/lone_circle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace foam::texgen {
namespace {

const ReliefOptions kSteepRelief{.angle = 30.0};
const MazeOptions kMaze;

using test::LoneCircle;

constexpr double kRadius = 25.0;  // pixels

// The walls of a furrow rise at 30 degrees. At its foot, the normal of a wall leans 30 degrees
// toward the other wall. The horizon on one side is the plane of the wall itself, 90 degrees from
// the normal. The other wall hides the sky up to 60 degrees from upright, which is 30 degrees from
// the normal. The visible fraction is therefore (sin 90 + sin 30) / 2 = 0.75. In the middle of a
// cap nothing hides the sky.
TEST(Occlusion, IsThatOfAFurrow) {
    LoneCircle circle(kRadius);
    const auto image = draw_occlusion(circle.layers, {kSteepRelief, kMaze}, {});
    EXPECT_NEAR(image.pixels.pixel(32, 32)[0], 1.0, 1e-3);
    float minimum = 1.0F;
    for (int y = 0; y < test::kCircleImage; ++y) {
        for (int x = 0; x < test::kCircleImage; ++x) {
            minimum = std::min(minimum, image.pixels.pixel(x, y)[0]);
        }
    }
    EXPECT_NEAR(minimum, 0.75, 0.01);  // somewhere near the rim
    EXPECT_EQ(image.pixels.pixel(0, 0)[0], 1.0F);
    const auto squared = draw_occlusion(circle.layers, {kSteepRelief, kMaze}, {.strength = 2.0});
    EXPECT_NEAR(
        squared.pixels.pixel(20, 40)[0], std::pow(image.pixels.pixel(20, 40)[0], 2.0), 1e-6);
}

TEST(Occlusion, LimitsHoldOnBothSides) {
    test::expect_limits(occlusion_keys(), {{"strength", "-1", "0", "100", "101"}});
}

}  // namespace
}  // namespace foam::texgen
