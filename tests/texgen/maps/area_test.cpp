// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/area.h"

#include "tests/texgen/keys/limits.h"
#include "tests/texgen/maps/lone_circle.h"

#include <gtest/gtest.h>

#include <numbers>

namespace foam::texgen {
namespace {

using test::LoneCircle;

// The disc has the area pi. It is the only bubble, so this is also the current mean area.
TEST(Area, IsInMeanAreas) {
    LoneCircle circle(20.0);
    const auto at_middle = [&](const AreaOptions& options) {
        return draw_area(circle.layers, options).pixels.pixel(32, 32)[0];
    };
    EXPECT_NEAR(at_middle({.unit = MeanBubble::Seed}), std::numbers::pi, 1e-6);
    EXPECT_NEAR(at_middle({.unit = MeanBubble::Current}), 1.0, 1e-6);
    // The default unit does not change at a T2, so that the areas of other bubbles do not jump.
    EXPECT_EQ(at_middle({}), at_middle({.unit = MeanBubble::Seed}));
    EXPECT_EQ(draw_area(circle.layers, {.full = {9.0}}).high, 9.0);
}

TEST(Area, LimitsHoldOnBothSides) {
    test::expect_limits(area_keys(), {{"full", "0", "0.001", "1e6", "1000001"}});
}

TEST(Area, ChoicesHaveTheirWords) {
    test::expect_words(area_keys(), "unit", {"seed", "current"});
}

}  // namespace
}  // namespace foam::texgen
