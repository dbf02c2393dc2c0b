// SPDX-License-Identifier: Apache-2.0

// Tests the coarsening of free patches, which lose their gas to the atmosphere until no bubble is
// left.
#include "core/dynamics/step.h"
#include "core/foam/frame.h"
#include "core/foam/measure.h"
#include "core/foam/statistics.h"
#include "tests/core/foams.h"
#include "tests/core/patches.h"

#include <gtest/gtest.h>

#include <numbers>

namespace foam {
namespace {

constexpr double kPi = std::numbers::pi;

Foam equilibrated(Foam foam) {
    EXPECT_TRUE(equilibrate(foam, {}).converged());
    return foam;
}

// The gas that enters a bubble through its films per unit of time is kappa times the sum of
// pressure difference times length, over all films including outer ones. In equilibrium this is von
// Neumann's law, because the films of a bubble of n sides turn by 2 pi - n pi / 3 in all, and the
// pressure difference is the tension times the curvature.
TEST(PatchStep, GasThroughTheFilmsIsVonNeumannsLaw) {
    const CoarseningOptions options{.kappa = 0.03};
    for (const Foam& foam : {equilibrated(test::double_bubble(1.0, 2.0)),
                             equilibrated(test::flower(1.0)),
                             equilibrated(test::chain())}) {
        for (const BubbleId bubble : foam.network.bubbles()) {
            double inflow = 0.0;
            for (const HalfEdgeId h : foam.network.around(bubble)) {
                inflow -= pressure_difference(foam, h) * arc_length(film_arc(foam, h));
            }
            EXPECT_NEAR(options.kappa * inflow, growth_rate(foam, bubble, options), 1e-9);
        }
    }
}

// A lone bubble of radius r has the pressure p = T / r. It loses gas at the rate
// kappa p 2 pi r = 2 pi T kappa, whatever its radius.
TEST(PatchStep, ALoneBubbleLosesGasAtAConstantRate) {
    Foam foam = equilibrated(test::double_bubble(1.0, 1.0));
    foam.film_tension = 0.8;
    const CoarseningOptions options{.kappa = 0.03};
    EXPECT_NEAR(lone_growth_rate(foam, options), -2.0 * kPi * 0.8 * 0.03, 1e-15);
}

// The total target area changes at the sum of the growth rates. The foam is in equilibrium
// afterwards.
TEST(PatchStep, LosesTheGasThatFlowsThroughOuterFilms) {
    Foam foam = equilibrated(test::flower(1.0));
    const StepOptions options;
    double rate = 0.0;
    for (const BubbleId bubble : foam.network.bubbles()) {
        rate += growth_rate(foam, bubble, options.coarsening);
    }
    const double time = 0.5;
    ASSERT_TRUE(step(foam, time, options).equilibrium.converged());
    EXPECT_NEAR(test::total_target(foam), 7.0 + rate * time, 1e-12);
    EXPECT_LT(equilibrium_errors(foam).area, 1e-9);
    EXPECT_NEAR(foam.target_areas[BubbleId{0}], 1.0, 1e-12);  // bubble 0 has six sides
}

std::size_t bubbles_of(const Foam& foam) {
    return foam.network.bubble_count() + foam.lone_bubbles.size();
}

// A patch coarsens until no bubble is left. A further step of the empty patch also converges.
TEST(PatchStep, RunsUntilTheLastBubble) {
    for (Foam foam : {equilibrated(test::double_bubble(1.0, 2.0)),
                      equilibrated(test::triple_bubble(1.0)),
                      equilibrated(test::flower(1.0)),
                      equilibrated(test::chain())}) {
        StepOptions options;
        options.coarsening.kappa = 1.0;
        for (int k = 0; k < 400 && bubbles_of(foam) > 0; ++k) {
            const StepSummary summary = step(foam, 0.02, options);
            ASSERT_TRUE(summary.equilibrium.converged()) << k;
            ASSERT_TRUE(test::is_valid(foam.network)) << k;
        }
        EXPECT_EQ(bubbles_of(foam), 0U);
        EXPECT_TRUE(step(foam, 0.02, options).equilibrium.converged());
        EXPECT_EQ(energy(foam), 0.0);
        const FoamStatistics nothing = statistics(snapshot(foam, 1));
        EXPECT_EQ(nothing.bubbles, 0);
        EXPECT_EQ(nothing.mean_area, 0.0);
        EXPECT_EQ(nothing.second_moment, 0.0);
    }
}

// The smaller of two bubbles vanishes as a two-sided bubble at the surface of the larger one, which
// becomes a lone bubble.
TEST(PatchStep, TheLastOfTwoIsALoneBubble) {
    Foam foam = equilibrated(test::double_bubble(0.1, 2.0));
    StepOptions options;
    options.coarsening.kappa = 0.1;
    while (foam.network.bubble_count() > 0) {
        ASSERT_TRUE(step(foam, 0.05, options).equilibrium.converged());
    }
    ASSERT_EQ(foam.lone_bubbles.size(), 1U);
    EXPECT_EQ(foam.lone_bubbles[0].identity, 1U);
    const double radius = lone_radius(foam.lone_bubbles[0]);
    EXPECT_NEAR(energy(foam), 2.0 * kPi * radius, 1e-12);
    EXPECT_GT(foam.lone_bubbles[0].target_area, 1.5);
}

TEST(PatchStep, StatisticsCountLoneBubbles) {
    Foam foam = equilibrated(test::double_bubble(1.0, 2.0));
    foam.lone_bubbles.push_back({7, {5.0, 5.0}, 3.0});
    const FoamStatistics all = statistics(snapshot(foam, 1));
    EXPECT_EQ(all.bubbles, 3);
    EXPECT_NEAR(all.mean_area, 2.0, 1e-9);
    EXPECT_NEAR(all.energy, energy(foam), 1e-9);
    ASSERT_EQ(all.by_sides.size(), 2U);
    EXPECT_EQ(all.by_sides[0].sides, 0);
    EXPECT_NEAR(all.by_sides[0].mean_inflow, -2.0 * kPi, 1e-12);
    EXPECT_NEAR(all.by_sides[1].mean_inflow, kPi / 3.0 * (2 - 6), 1e-9);
}

// After the step all gas is in the atmosphere.
TEST(PatchStep, StatisticsWithoutBubblesAreZero) {
    Foam foam = equilibrated(test::double_bubble(1.0, 1.0));
    StepOptions options;
    options.coarsening.kappa = 1.0;
    ASSERT_TRUE(step(foam, 2.0, options).equilibrium.converged());
    ASSERT_EQ(bubbles_of(foam), 0U);
    const FoamStatistics none = statistics(snapshot(foam, 1));
    EXPECT_EQ(none.bubbles, 0);
    EXPECT_EQ(none.mean_area, 0.0);
    EXPECT_EQ(none.energy, 0.0);
    EXPECT_EQ(none.mean_sides, 0.0);
    EXPECT_EQ(none.second_moment, 0.0);
    EXPECT_TRUE(none.by_sides.empty());
}

}  // namespace
}  // namespace foam
