// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/bubble_pressure.h"

#include "core/foam/honeycomb.h"
#include "tests/texgen/maps/lone_circle.h"

#include <gtest/gtest.h>

namespace foam::texgen {
namespace {

using test::LoneCircle;

// A torus of four hexagons of area 1 each, and film tension 2: in the unit of the seeded foam, a
// pressure of 3 is 1.5.
TEST(BubblePressure, IsOverTheFilmTension) {
    Frame frame = snapshot(honeycomb(2, 2), 1);
    frame.film_tension = 2.0;
    frame.bubbles[id_at<BubbleId>(1)].pressure = 3.0;
    EXPECT_DOUBLE_EQ(pressures_of(frame, PressureUnit::Seed)[1], 1.5);
}

// Areas four times as large have lengths twice as large.
TEST(BubblePressure, InTheCurrentUnitItGrowsWithTheMeanLength) {
    Frame frame = snapshot(honeycomb(2, 2), 1);
    for (FrameBubble& bubble : frame.bubbles) {
        bubble.area = 4.0;
        bubble.pressure = frame.film_tension;
    }
    frame.domain.width *= 2.0;
    frame.domain.height *= 2.0;
    EXPECT_NEAR(pressures_of(frame, PressureUnit::Current)[0], 2.0, 1e-12);
    EXPECT_DOUBLE_EQ(pressures_of(frame, PressureUnit::Seed)[0], 1.0);
}

// Laplace's law: a circle of radius 1 holds a pressure of the film tension over 1.
TEST(BubblePressure, OfALoneBubbleFollowsFromItsRadius) {
    const LoneCircle circle(20.0);
    EXPECT_NEAR(pressures_of(circle.frame, PressureUnit::Seed).at(0), 1.0, 1e-12);
}

}  // namespace
}  // namespace foam::texgen
