// SPDX-License-Identifier: Apache-2.0

#include "core/dynamics/state_change.h"

#include "core/dynamics/step.h"
#include "core/foam/honeycomb.h"
#include "core/foam/locate.h"
#include "tests/core/foams.h"
#include "tests/core/patches.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace foam {
namespace {

using test::equilibrated_foam;
using test::total_target;

TEST(Drive, MovesTowardsTheTargetAndOthersGiveInProportion) {
    Foam foam = honeycomb(4, 4);
    foam.target_areas[BubbleId{0}] = 2.0;  // the other bubbles have 14 of 16
    foam.target_areas[BubbleId{1}] = 1.0;
    foam.target_areas[BubbleId{2}] = 3.0;
    for (std::size_t k = 3; k < 16; ++k) {
        foam.target_areas[id_at<BubbleId>(k)] = 10.0 / 13.0;
    }
    drive(foam, {{{0, 16.0, false}}}, 0.25);  // 2 + (16 - 2) / 4 = 5.5
    EXPECT_NEAR(foam.target_areas[BubbleId{0}], 5.5, 1e-14);
    EXPECT_NEAR(foam.target_areas[BubbleId{1}], 10.5 / 14.0, 1e-14);
    EXPECT_NEAR(foam.target_areas[BubbleId{2}], 3.0 * 10.5 / 14.0, 1e-14);
    EXPECT_NEAR(total_target(foam), 16.0, 1e-13);
}

TEST(Drive, LeavesATenthOfTheTorusToOthers) {
    Foam foam = honeycomb(4, 4);
    drive(foam, {{{3, 12.0, false}, {4, 36.0, false}}}, 1.0);  // 48 in all; at most 0.9 * 16
    EXPECT_NEAR(foam.target_areas[BubbleId{3}], 3.6, 1e-13);
    EXPECT_NEAR(foam.target_areas[BubbleId{4}], 10.8, 1e-13);
    EXPECT_NEAR(foam.target_areas[BubbleId{5}], 1.6 / 14.0, 1e-14);
    EXPECT_NEAR(total_target(foam), 16.0, 1e-13);
}

TEST(Drive, DrivenBubblesFillTheTorusIfAllAreDriven) {
    Foam foam = honeycomb(2, 2);
    drive(foam, {{{0, 1.0, false}, {1, 1.0, false}, {2, 1.0, false}, {3, 5.0, false}}}, 1.0);
    EXPECT_NEAR(foam.target_areas[BubbleId{0}], 0.5, 1e-14);
    EXPECT_NEAR(foam.target_areas[BubbleId{3}], 2.5, 1e-14);
}

TEST(Drive, IgnoresVanishedBubbles) {
    Foam foam = honeycomb(4, 4);
    const Foam before = foam;
    drive(foam, {{{77, 3.0, false}}}, 1.0);
    EXPECT_TRUE(test::are_same(foam, before));
}

TEST(MaxFractionOfChange, LimitsLossAndGain) {
    const Foam foam = honeycomb(4, 4);
    const auto fraction = [&](double target, double vanishing) {
        return max_fraction_of_change(foam, {{{2, target, false}}}, 0.75, vanishing);
    };
    EXPECT_DOUBLE_EQ(fraction(0.5, 0.1), 1.0);
    EXPECT_DOUBLE_EQ(fraction(0.1, 0.1), 0.75 / 0.9);
    EXPECT_DOUBLE_EQ(fraction(0.1, 1.5), 1.0);  // small enough to vanish
    EXPECT_DOUBLE_EQ(fraction(4.0, 0.1), 1.0);
    EXPECT_DOUBLE_EQ(fraction(7.0, 0.1), 0.5);
    EXPECT_DOUBLE_EQ(fraction(1.0, 0.1), 1.0);  // there already
}

// Driven bubbles have the given target areas at the end of the step, although gas diffuses, and the
// foam time advances by the time of the step.
TEST(StateChange, IsImposedInTheCourseOfAStep) {
    Foam foam = equilibrated_foam(60, 2);
    const StepSummary summary = step(foam, 2.0, {{{5, 3.0, false}, {9, 0.2, false}}}, {});
    EXPECT_TRUE(summary.equilibrium.converged());
    EXPECT_GT(summary.substeps, 1);
    EXPECT_NEAR(foam.time, 2.0, 1e-12);
    EXPECT_NEAR(foam.target_areas[BubbleId{5}], 3.0, 1e-12);
    EXPECT_NEAR(foam.target_areas[BubbleId{9}], 0.2, 1e-12);
    EXPECT_NEAR(total_target(foam), foam.domain.area(), 1e-10);
    EXPECT_LT(summary.equilibrium.area_error, 1e-9);
}

TEST(StateChange, AnEmptyChangeIsAPlainStep) {
    Foam a = equilibrated_foam(60, 2);
    Foam b = a;
    step(a, 3.0, StateChange{}, {});
    step(b, 3.0, {});
    EXPECT_TRUE(test::are_same(a, b));
}

// Target areas oscillate and return to their initial values (E9). Without T1, the foam also returns
// to its initial state, up to a translation.
TEST(StateChange, RestoredAreasRestoreTheFoam) {
    Foam foam = equilibrated_foam(60, 4);
    const Foam before = foam;
    int flips = 0;
    for (int k = 1; k <= 12; ++k) {
        const double swing = 1.0 + 0.05 * std::sin(std::numbers::pi * k / 6.0);
        StateChange change;
        for (std::uint32_t identity = 0; identity < 30; ++identity) {
            change.driven.push_back(
                {identity, swing * before.target_areas[id_at<BubbleId>(identity)], false});
        }
        const StepSummary summary = step(foam, 0.0, change, {});
        ASSERT_TRUE(summary.equilibrium.converged());
        flips += summary.equilibrium.t1;
    }
    ASSERT_EQ(flips, 0);
    for (const BubbleId bubble : foam.network.bubbles()) {
        EXPECT_NEAR(foam.target_areas[bubble], before.target_areas[bubble], 1e-12);
        EXPECT_NEAR(foam.pressures[bubble], before.pressures[bubble], 1e-8);
    }
}

// In a patch the gas comes from and goes to the atmosphere. Other bubbles, lone or not, keep their
// target areas.
TEST(Drive, KeepsOtherBubblesOfAPatch) {
    Foam foam = test::flower(1.0);
    foam.lone_bubbles = {{20, {9.0, 0.0}, 0.5}, {21, {9.0, 9.0}, 0.7}};
    drive(foam, {{{2, 3.0, false}, {21, 0.3, false}}}, 0.25);
    EXPECT_NEAR(foam.target_areas[BubbleId{2}], 1.5, 1e-15);
    EXPECT_EQ(foam.target_areas[BubbleId{3}], 1.0);
    EXPECT_EQ(foam.lone_bubbles[0].target_area, 0.5);
    EXPECT_NEAR(foam.lone_bubbles[1].target_area, 0.6, 1e-15);
}

// A bubble of a patch of seven, the middle one or an outer one, collapses on command together with
// a lone bubble.
TEST(ForcedCollapse, CollapsesABubbleOfAPatchAndALoneBubble) {
    for (const BubbleIdentity bubble : {0U, 3U}) {
        Foam foam = test::flower(1.0);
        ASSERT_TRUE(equilibrate(foam, {}).converged());
        foam.lone_bubbles = {{20, {9.0, 0.0}, 0.5}};
        StepOptions options;
        options.coarsening.kappa = 0.0;
        const TopologyThresholds thresholds;
        const StateChange change{
            {forced_collapse(bubble, thresholds), forced_collapse(20, thresholds)}};
        const StepSummary summary = step(foam, 0.0, change, options);
        ASSERT_TRUE(summary.equilibrium.converged()) << bubble;
        EXPECT_TRUE(test::is_valid(foam.network));
        EXPECT_EQ(summary.equilibrium.t2, 2);
        EXPECT_EQ(foam.network.bubble_count(), 6U);
        EXPECT_EQ(find_bubble(foam, bubble), std::nullopt);
        EXPECT_TRUE(foam.lone_bubbles.empty());
    }
}

// The first of two bubbles to vanish removes the film between them, and the other one is alone.
TEST(StateChange, BothBubblesOfARaftMayVanishInOneStep) {
    Foam foam = test::double_bubble(1.0, 2.0);
    StateChange change;
    for (const BubbleId bubble : foam.network.bubbles()) {
        change.driven.push_back({foam.identities[bubble], 0.0, true});
    }
    ASSERT_EQ(change.driven.size(), 2U);
    EXPECT_EQ(collapse_forced(foam, change).t2, 2);
    EXPECT_EQ(foam.network.bubble_count(), 0);
    EXPECT_EQ(foam.network.film_count(), 0);
    EXPECT_TRUE(foam.lone_bubbles.empty());
    EXPECT_TRUE(test::is_valid(foam.network));
}

}  // namespace
}  // namespace foam
