// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/event.h"

#include "tests/texgen/keys/limits.h"
#include "tests/texgen/maps/lone_circle.h"

#include <gtest/gtest.h>

#include <numbers>

namespace foam::texgen {
namespace {

using test::LoneCircle;

// The disk has a radius of 8 pixels and is shown in its third frame of 4, so its center has the
// value 0.5. Half the radius away, the value is multiplied by (1 - 1/4)².
TEST(Event, ADiskFadesInTimeAndSpace) {
    LoneCircle circle(20.0);
    circle.record.frame = 5;
    circle.record.events = {{TopologyEventKind::T2, 3, {0.025, 0.025}},
                            {TopologyEventKind::T1, 1, {0.025, 0.025}}};
    const double diameter = 2.0 * std::numbers::inv_sqrtpi;
    const NumberPixels image =
        draw_event(circle.layers, {.radius = 8.0 / (20.0 * diameter), .fade = 4});
    EXPECT_EQ(image.pixels.pixel(32, 32)[1], 0.5F);
    EXPECT_NEAR(image.pixels.pixel(36, 32)[1], 0.5 * 0.5625, 1e-6);
    EXPECT_EQ(image.pixels.pixel(32, 41)[1], 0.0F);
    EXPECT_EQ(image.pixels.pixel(32, 32)[0], 0.0F);  // the T1 has faded out
    EXPECT_EQ(image.pixels.pixel(32, 32)[2], 0.0F);
}

TEST(Event, LimitsHoldOnBothSides) {
    test::expect_limits(event_map_keys(),
                        {{"radius", "0", "0.01", "100", "101"}, {"fade", "0", "1", "100", "101"}});
}

}  // namespace
}  // namespace foam::texgen
