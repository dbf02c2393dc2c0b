// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/bubble_values.h"

#include "core/foam/honeycomb.h"
#include "tests/support/sample_foams.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <numbers>

namespace foam::texgen {
namespace {

TEST(BubbleValues, PresentValuesAreThoseOfTheFrame) {
    Foam foam = honeycomb(4, 4);
    foam.film_tension = 2.0;
    for (double& pressure : foam.pressures) {
        pressure = 3.0;
    }
    const Frame frame = snapshot(foam, 1);
    const FoamValues values = present_values(frame);
    ASSERT_EQ(values.bubbles.size(), 16U);
    for (const BubbleValues& bubble : values.bubbles) {
        EXPECT_EQ(bubble.pressure, 1.5);
        EXPECT_EQ(bubble.sides, 6.0);
        EXPECT_NEAR(bubble.area, values.mean_area, 1e-12);
    }
    EXPECT_EQ(shown_values(frame, {}).bubbles, values.bubbles);
}

// The pressure in a circle of radius 2 is the film tension / 2, relative to the surroundings.
TEST(BubbleValues, ALoneBubbleHasNoSides) {
    const Frame frame = snapshot(foam::test::circles({{7, {0.0, 0.0}, 4.0 * std::numbers::pi}}), 1);
    const FoamValues values = present_values(frame);
    ASSERT_EQ(values.bubbles.size(), 1U);
    EXPECT_NEAR(values.bubbles.front().pressure, 0.5, 1e-12);
    EXPECT_NEAR(values.bubbles.front().area, 4.0 * std::numbers::pi, 1e-12);
    EXPECT_EQ(values.bubbles.front().sides, 0.0);
}

TEST(BubbleValues, AveragesReplacePresentValues) {
    const Frame frame = snapshot(foam::test::circles({{7, {0.0, 0.0}, 4.0 * std::numbers::pi}}), 1);
    FoamRecord record;
    record.averages.bubbles.resize(8);
    record.averages.bubbles[7] = {0.75, 3.0, 1.0};
    record.averages.mean_area = 4.0;
    const FoamValues values = shown_values(frame, record);
    ASSERT_EQ(values.bubbles.size(), 1U);
    // p / (1 + p) = 0.75 for p = 3, in units of 1 / sqrt(4).
    EXPECT_EQ(values.bubbles.front(), (BubbleValues{1.5, 3.0, 1.0}));
    EXPECT_EQ(values.mean_area, 4.0);
}

TEST(BubbleValues, AveragesOfOneFrameAreItsValues) {
    const Frame frame = snapshot(foam::test::polydisperse_foam(24, 5), 1);
    const FoamValues present = present_values(frame);
    const FoamValues averaged = values_to_average(frame);
    FoamRecord record;
    for (std::size_t k = 0; k < frame.bubbles.size(); ++k) {
        const BubbleIdentity identity = frame.bubbles[id_at<BubbleId>(k)].identity;
        record.averages.bubbles.resize(
            std::max(record.averages.bubbles.size(), std::size_t{identity} + 1));
        record.averages.bubbles[identity] = averaged.bubbles[k];
    }
    record.averages.mean_area = averaged.mean_area;
    const FoamValues shown = shown_values(frame, record);
    for (std::size_t k = 0; k < frame.bubbles.size(); ++k) {
        EXPECT_NEAR(shown.bubbles[k].pressure, present.bubbles[k].pressure, 1e-12);
        EXPECT_EQ(shown.bubbles[k].area, present.bubbles[k].area);
    }
}

}  // namespace
}  // namespace foam::texgen
