// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/bubble_pressure.h"

#include "core/foam/honeycomb.h"
#include "tests/texgen/maps/lone_circle.h"

#include <gtest/gtest.h>

namespace foam::texgen {
namespace {

using test::LoneCircle;

// The film tension is 2 and the mean area of the seeded foam is 1, so the unit of pressure is 2.
TEST(BubblePressure, IsOverTheFilmTension) {
    Frame frame = snapshot(honeycomb(2, 2), 1);
    frame.film_tension = 2.0;
    frame.bubbles[id_at<BubbleId>(1)].pressure = 3.0;
    EXPECT_DOUBLE_EQ(pressures_of(present_values(frame), PressureUnit::Seed)[1], 1.5);
}

// Areas that are four times as large have lengths that are twice as large.
TEST(BubblePressure, InTheCurrentUnitItGrowsWithTheMeanLength) {
    Frame frame = snapshot(honeycomb(2, 2), 1);
    for (FrameBubble& bubble : frame.bubbles) {
        bubble.area = 4.0;
        bubble.pressure = frame.film_tension;
    }
    frame.domain.width *= 2.0;
    frame.domain.height *= 2.0;
    EXPECT_NEAR(pressures_of(present_values(frame), PressureUnit::Current)[0], 2.0, 1e-12);
    EXPECT_DOUBLE_EQ(pressures_of(present_values(frame), PressureUnit::Seed)[0], 1.0);
}

// By Laplace's law, the pressure in a circle of radius 1 is the film tension divided by 1.
TEST(BubblePressure, OfALoneBubbleFollowsFromItsRadius) {
    const LoneCircle circle(20.0);
    EXPECT_NEAR(pressures_of(present_values(circle.frame), PressureUnit::Seed).at(0), 1.0, 1e-12);
}

}  // namespace
}  // namespace foam::texgen
