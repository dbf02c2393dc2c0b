// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/occlusion.h"

#include "tests/texgen/keys/limits.h"
#include "tests/texgen/maps/lone_circle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace foam::texgen {
namespace {

using test::LoneCircle;

constexpr double kRadius = 25.0;  // pixels

// At the foot of a furrow whose walls rise by 30 degrees a wall sees the sky from its own plane to
// 60 degrees from its normal on the other side ... the normal leans 30 degrees to the other wall,
// which ends 60 degrees from upright: (sin 90 + sin 30) / 2. In the middle of a cap nothing is
// above.
TEST(Occlusion, IsThatOfAFurrow) {
    LoneCircle circle(kRadius);
    const auto image = draw_occlusion(circle.layers, {.angle = 30.0}, {});
    EXPECT_NEAR(image.pixels.pixel(32, 32)[0], 1.0, 1e-3);
    float minimum = 1.0F;
    for (int y = 0; y < test::kCircleImage; ++y) {
        for (int x = 0; x < test::kCircleImage; ++x) {
            minimum = std::min(minimum, image.pixels.pixel(x, y)[0]);
        }
    }
    EXPECT_NEAR(minimum, 0.75, 0.01);  // somewhere near the rim
    EXPECT_EQ(image.pixels.pixel(0, 0)[0], 1.0F);
    const auto squared = draw_occlusion(circle.layers, {.angle = 30.0}, {.strength = 2.0});
    EXPECT_NEAR(
        squared.pixels.pixel(20, 40)[0], std::pow(image.pixels.pixel(20, 40)[0], 2.0), 1e-6);
}

TEST(Occlusion, LimitsHoldOnBothSides) {
    test::expect_limits(occlusion_keys(), {{"strength", "-1", "0", "100", "101"}});
}

}  // namespace
}  // namespace foam::texgen
