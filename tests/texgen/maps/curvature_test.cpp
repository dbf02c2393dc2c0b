// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/curvature.h"

#include "tests/texgen/keys/limits.h"
#include "tests/texgen/maps/lone_circle.h"
#include "tests/texgen/maps/spherical_cap.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace foam::texgen {
namespace {

const ReliefOptions kRelief;
const MazeOptions kMaze;

using test::LoneCircle;

constexpr double kRadius = 25.0;  // pixels

// In the middle of a cap, the difference of heights is the curvature of its sphere, up to an error
// of the second order in options.radius.
TEST(Curvature, OfACapIsThatOfItsSphere) {
    LoneCircle circle(kRadius);
    const auto image = draw_curvature(circle.layers, {kRelief, kMaze}, {.radius = 0.01});
    const test::SphericalCap cap{kRadius};
    const double expected = 2.0 * kRadius / cap.sphere;
    EXPECT_NEAR(image.pixels.pixel(32, 32)[0], expected, 0.02 * expected);
    float at_rim = 0.0F;
    const auto wide = draw_curvature(circle.layers, {kRelief, kMaze}, {.radius = 0.1});
    test::for_each_inside(kRadius, [&](int x, int y, const Vec2&) {
        at_rim = std::min(at_rim, wide.pixels.pixel(x, y)[0]);
    });
    EXPECT_LT(at_rim, -3.0F);  // the film is a furrow
    EXPECT_EQ(image.pixels.pixel(0, 0)[0], 0.0F);
}

TEST(Curvature, LimitsHoldOnBothSides) {
    test::expect_limits(
        curvature_keys(),
        {{"radius", "0", "0.001", "10", "11"}, {"full", "0", "1e-6", "1e6", "1e7"}});
}

}  // namespace
}  // namespace foam::texgen
