// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/growth.h"

#include "core/dynamics/step.h"
#include "tests/texgen/keys/limits.h"
#include "tests/texgen/maps/lone_circle.h"
#include "texgen/maps/sides.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <stdexcept>

namespace foam::texgen {
namespace {

using test::LoneCircle;

// The area grows from pi to pi + 0.5 in a time of 2. In a second case the bubble has vanished.
TEST(Growth, IsTheChangeOverTheTime) {
    LoneCircle circle(20.0);
    Frame next = snapshot(foam::test::circles({{7, {0.1, 0.0}, std::numbers::pi + 0.5}}), 2);
    next.time = 2.0;
    const auto at_middle = [&] {
        FrameLayers layers({circle.frame, circle.record, &next}, circle.layers.grid(), 1);
        return draw_growth(layers, {}).pixels.pixel(32, 32)[0];
    };
    EXPECT_NEAR(at_middle(), 0.25, 1e-6);
    next.lone_bubbles.clear();
    EXPECT_NEAR(at_middle(), -0.5 * std::numbers::pi, 1e-6);
    next.time = 0.0;
    EXPECT_EQ(at_middle(), 0.0F);
}

// If there is no T1 or T2 between two frames, every area follows von Neumann's law (E6).
TEST(Growth, IsVonNeumannsLaw) {
    Foam foam = foam::test::polydisperse_foam(24, 5);
    const Frame frame = snapshot(foam, 1);
    foam.events.clear();
    step(foam, 1e-3, {});
    ASSERT_TRUE(foam.events.empty());
    const Frame next = snapshot(foam, 2);
    const FoamRecord record;
    FrameLayers layers({frame, record, &next}, {64, 64}, 1);
    const NumberPixels growth = draw_growth(layers, {});
    FrameLayers again({frame, record}, {64, 64}, 1);
    const IdPixels sides = draw_sides(again);
    const double rate = std::numbers::pi / 3.0 * frame.film_tension * CoarseningOptions{}.kappa;
    int checked = 0;
    for (int x = 2; x < 62; ++x) {
        const auto near = {sides.pixels.pixel(x - 2, 20)[0], sides.pixels.pixel(x + 2, 20)[0]};
        const std::uint32_t here = sides.pixels.pixel(x, 20)[0];
        if (std::all_of(near.begin(), near.end(), [&](std::uint32_t n) { return n == here; })) {
            EXPECT_NEAR(growth.pixels.pixel(x, 20)[0], rate * (double(here) - 6.0), 1e-4);
            ++checked;
        }
    }
    EXPECT_GT(checked, 20);
}

TEST(Growth, LimitsHoldOnBothSides) {
    test::expect_limits(growth_keys(), {{"full", "0", "1e-9", "1e6", "1e7"}});
}

TEST(Growth, NeedsTheNextFrame) {
    LoneCircle circle(20.0);
    EXPECT_THROW(draw_growth(circle.layers, {}), std::invalid_argument);
}

}  // namespace
}  // namespace foam::texgen
