// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/reflections.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace foam::texgen {
namespace {

Direction tilted(double azimuth, double degrees) {
    return direction_of(azimuth, 90.0 - degrees);
}

// A window of 20 degrees in the direction of 50 degrees above the ground, 40 degrees from straight
// up, is seen in a mirror that is tilted by half of that.
TEST(Reflections, AMirrorShowsTheWindowHalfwayToIt) {
    const ReflectionOptions options{
        .windows = 1, .window_size = 20.0, .window_softness = 0.0, .window_brightness = 3.0};
    const Reflections reflections(options, 30.0, 50.0);
    EXPECT_NEAR(reflections.brightness(tilted(30.0, 20.0)), 3.0, 1e-12);
    EXPECT_NEAR(reflections.brightness(tilted(30.0, 24.5)), 3.0, 1e-12);
    EXPECT_EQ(reflections.brightness(tilted(30.0, 25.5)), 0.0);
    EXPECT_EQ(reflections.brightness(tilted(30.0, 14.5)), 0.0);
    EXPECT_EQ(reflections.brightness(tilted(210.0, 20.0)), 0.0);
}

TEST(Reflections, TheSecondWindowIsOppositeAndFainter) {
    const ReflectionOptions options{.windows = 2};
    const Reflections reflections(options, 30.0, 50.0);
    EXPECT_NEAR(reflections.brightness(tilted(30.0, 20.0)), 1.0, 1e-12);
    EXPECT_NEAR(reflections.brightness(tilted(210.0, 20.0)), 0.4, 1e-12);
}

// The horizon is reflected by a mirror of 45 degrees, the ground by a steeper one.
TEST(Reflections, TheSkyIsBrightestAtTheHorizon) {
    const ReflectionOptions options{.horizon = 2.0};
    const Reflections reflections(options, 30.0, 50.0);
    const double low = std::sin(10.0 * std::numbers::pi / 180.0);
    EXPECT_NEAR(reflections.brightness(tilted(70.0, 40.0)), 2.0 * std::pow(1.0 - low, 4), 1e-12);
    EXPECT_EQ(reflections.brightness(tilted(70.0, 50.0)), 0.0);
    EXPECT_EQ(reflections.brightness(tilted(70.0, 0.0)), 0.0);
}

TEST(Reflections, NothingIsReflectedByDefault) {
    const ReflectionOptions options;
    EXPECT_TRUE(Reflections(options, 30.0, 50.0).are_none());
}

}  // namespace
}  // namespace foam::texgen
