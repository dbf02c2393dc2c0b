// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/relief_section.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace foam::texgen {
namespace {

// The height of a ridge and of a fillet is 0 at the distance 1. A ridge is half as high as this
// distance. At the distance 0.1, a fillet has the height 1 - sqrt(0.19) and the slope -0.9 /
// sqrt(0.19). From there to the film, the slope changes linearly to 0.
TEST(ReliefSection, RidgesAndBordersStandOnFilms) {
    const ReliefSection ridge(ReliefProfile::Ridge, 1.0);
    EXPECT_EQ(ridge.height(0.0), 0.5);
    EXPECT_EQ(ridge.slope(0.0), 0.0);
    EXPECT_EQ(ridge.height(1.0), 0.0);
    EXPECT_NEAR(ridge.height(0.5), 0.5 * 0.75 * 0.75, 1e-15);
    const ReliefSection wet(ReliefProfile::Wet, 1.0);
    const double root = std::sqrt(0.19);
    EXPECT_NEAR(wet.height(0.1), 1.0 - root, 1e-15);
    EXPECT_NEAR(wet.slope(0.1), -0.9 / root, 1e-15);
    EXPECT_NEAR(wet.height(0.0), 1.0 - root + 0.05 * 0.9 / root, 1e-15);
    EXPECT_EQ(wet.slope(0.0), 0.0);
    EXPECT_NEAR(wet.height(1.0), 0.0, 1e-15);
    EXPECT_EQ(wet.slope(1.5), 0.0);
}

// An empty patch has no films, so the smooth distance is infinite.
TEST(ReliefSection, RidgesAndBordersAreFlatFarAway) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    for (const auto profile : {ReliefProfile::Ridge, ReliefProfile::Wet}) {
        const ReliefSection section(profile, 1.0);
        EXPECT_NEAR(section.height(kInfinity), 0.0, 1e-15);
        EXPECT_EQ(section.slope(kInfinity), 0.0);
    }
}

TEST(ReliefSection, SlopesAreDerivativesOfHeights) {
    constexpr double kStep = 1e-5;
    for (const auto profile : {ReliefProfile::Dome, ReliefProfile::Ridge, ReliefProfile::Wet}) {
        const ReliefSection section(profile, 0.9);
        for (const double s : {0.05, 0.07, 0.2, 0.45, 0.7, 0.95, 1.3}) {
            const double difference =
                (section.height(s + kStep) - section.height(s - kStep)) / (2.0 * kStep);
            EXPECT_NEAR(section.slope(s), difference, 1e-7) << s;
            if (s < 0.5) {
                EXPECT_NEAR(section.smooth(section.distance(s)), s, 1e-12);
            }
        }
    }
}

// A bubble may be smaller than the distance over which curvature is measured. Beyond the middle of
// a dome comes the film on its other side, and beyond that film the next dome.
TEST(ReliefSection, ADomeGoesOnInBothDirections) {
    constexpr DomeSection dome{0.8};
    for (const double x : {0.0, 0.3, 0.9}) {
        for (const double far : {-x, 2.0 - x, 2.0 + x, 8.0 - x, -40.0 - x}) {
            EXPECT_NEAR(height_along(dome, far), height_along(dome, x), 1e-14) << far;
        }
    }
    EXPECT_GT(height_along(dome, 1.0), height_along(dome, 0.9));
}

}  // namespace
}  // namespace foam::texgen
