// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/visible_sky.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace foam::texgen {
namespace {

constexpr double kAngle = 50.0 * std::numbers::pi / 180.0;

// Two domes meet at a film in a valley whose sides both rise at 50 degrees: the sky is visible
// between 40 degrees on both sides of straight up. The normal there is that of one of the sides.
// The horizon is found at one of 128 points per unit.
TEST(VisibleSky, AFilmBetweenDomesSeesTheSkyBetweenThem) {
    const VisibleSky sky(ReliefSection(ReliefProfile::Dome, kAngle), 1.0, 1.0);
    const double left = std::numbers::pi / 2.0 - 2.0 * kAngle;
    EXPECT_NEAR(sky.lookup().at(0.0), 0.5 * (1.0 + std::sin(left)), 5e-3);
}

TEST(VisibleSky, IsWholeFarAway) {
    for (const auto profile : {ReliefProfile::Ridge, ReliefProfile::Wet}) {
        const VisibleSky sky(ReliefSection(profile, kAngle), 1.0, 1.0);
        EXPECT_GT(sky.lookup().at(4.0), 0.97);
        EXPECT_EQ(sky.lookup().at(std::numeric_limits<double>::infinity()), 1.0);
    }
}

TEST(VisibleSky, TheExponentIsAPower) {
    const ReliefSection section(ReliefProfile::Wet, kAngle);
    const VisibleSky once(section, 1.0, 1.0);
    const VisibleSky cubed(section, 1.0, 3.0);
    EXPECT_NEAR(cubed.lookup().at(0.5), std::pow(once.lookup().at(0.5), 3.0), 1e-12);
}

TEST(VisibleSky, FlatGroundSeesTheWholeSky) {
    const VisibleSky sky(ReliefSection(ReliefProfile::Dome, kAngle), 0.0, 1.0);
    EXPECT_NEAR(sky.lookup().at(0.3), 1.0, 1e-15);
}

}  // namespace
}  // namespace foam::texgen
