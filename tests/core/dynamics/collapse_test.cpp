// SPDX-License-Identifier: Apache-2.0

#include "core/dynamics/collapse.h"

#include "core/equilibrium/equilibrate.h"
#include "core/foam/honeycomb.h"
#include "tests/core/foams.h"
#include "tests/core/patches.h"
#include "tests/support/sample_foams.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace foam {
namespace {

using test::honeycomb_around;
using test::is_valid;
using test::total_target;

constexpr BubbleId kDying{5};

TEST(Collapse, IsDueAtTheT2AreaOrATenthOfIt) {
    const TopologyThresholds thresholds{.t2_area = 0.01};
    struct Case {
        int sides;
        double largest;  // largest target area at which the bubble is due
    };
    for (const Case& c : {Case{2, 0.01}, Case{3, 0.01}, Case{4, 0.001}, Case{5, 0.001}}) {
        Foam foam = honeycomb_around(c.sides);
        ASSERT_EQ(foam.network.sides(kDying), c.sides);
        foam.target_areas[kDying] = 0.999 * c.largest;
        EXPECT_TRUE(is_due_to_vanish(foam, kDying, thresholds)) << c.sides;
        foam.target_areas[kDying] = 1.001 * c.largest;
        EXPECT_FALSE(is_due_to_vanish(foam, kDying, thresholds)) << c.sides;
        foam.target_areas[kDying] = -0.5;  // diffusion may make a target area negative
        EXPECT_TRUE(is_due_to_vanish(foam, kDying, thresholds)) << c.sides;
    }
}

// A bubble of n sides needs n - 3 T1s before it can vanish with three sides. A bubble of two sides
// needs none.
TEST(Collapse, TakesAllButThreeSidesByT1) {
    for (int sides = 2; sides <= 6; ++sides) {
        Foam foam = honeycomb_around(sides);
        TopologyCounts counts;
        ASSERT_TRUE(collapse(foam, kDying, counts)) << sides;
        EXPECT_TRUE(is_valid(foam.network)) << sides;
        EXPECT_FALSE(foam.network.is_live(kDying));
        EXPECT_EQ(foam.network.bubble_count(), 15U);
        EXPECT_EQ(counts.t1, std::max(sides - 3, 0)) << sides;
        EXPECT_EQ(counts.t2, 1);
    }
}

// The bubble vanishes with three or two sides. Each of its last neighbors gets an equal part of the
// gas.
TEST(Collapse, SharesTheGasAmongTheLastNeighbors) {
    for (int sides = 2; sides <= 6; ++sides) {
        Foam foam = honeycomb_around(sides);
        foam.target_areas[kDying] = 0.3;
        const Foam before = foam;
        TopologyCounts counts;
        collapse(foam, kDying, counts);
        const int last_neighbors = std::min(sides, 3);
        int receivers = 0;
        for (const BubbleId bubble : foam.network.bubbles()) {
            const double gain = foam.target_areas[bubble] - before.target_areas[bubble];
            EXPECT_TRUE(gain == 0.0 || std::abs(gain - 0.3 / last_neighbors) < 1e-14);
            receivers += gain == 0.0 ? 0 : 1;
        }
        EXPECT_EQ(receivers, last_neighbors);
        EXPECT_NEAR(total_target(foam), total_target(before), 1e-13);
    }
}

// If the target area is negative, the last neighbors lose gas.
TEST(Collapse, KeepsTheTotalOfANegativeTargetToo) {
    Foam foam = honeycomb_around(3);
    foam.target_areas[kDying] = -0.3;
    const double total = total_target(foam);
    TopologyCounts counts;
    collapse(foam, kDying, counts);
    EXPECT_NEAR(total_target(foam), total, 1e-13);
}

TEST(Collapse, LeavesTheJunctionAtTheMeanOfTheThree) {
    Foam foam = honeycomb_around(3);
    Vec2 sum = Vec2::Zero();
    Vec2 at = foam.positions[foam.network.tail(foam.network.first(kDying))];
    const JunctionId remaining = foam.network.tail(foam.network.first(kDying));
    for (const HalfEdgeId h : foam.network.around(kDying)) {
        sum += at;
        at += chord(foam, h);
    }
    TopologyCounts counts;
    collapse(foam, kDying, counts);
    ASSERT_TRUE(foam.network.is_live(remaining));
    EXPECT_LT((foam.positions[remaining] - sum / 3.0).norm(), 1e-14);
}

// All films are disarmed first. The film that replaces a vanished two-sided bubble is new and
// therefore armed.
TEST(Collapse, ArmsTheFilmThatALensLeaves) {
    Foam foam = honeycomb_around(2);
    std::fill(foam.t1_armed.begin(), foam.t1_armed.end(), std::uint8_t{0});
    TopologyCounts counts;
    collapse(foam, kDying, counts);
    EXPECT_EQ(std::count(foam.t1_armed.begin(), foam.t1_armed.end(), std::uint8_t{1}), 1);
}

TEST(Collapse, OfAnyBubbleLeadsToAnEquilibrium) {
    const Foam equilibrated = test::equilibrated_foam(40, 3);
    for (const BubbleId bubble : equilibrated.network.bubbles()) {
        Foam foam = equilibrated;
        TopologyCounts counts;
        ASSERT_TRUE(collapse(foam, bubble, counts));
        ASSERT_TRUE(is_valid(foam.network));
        compact(foam);
        EXPECT_NEAR(total_target(foam), foam.domain.area(), 1e-12);
        EXPECT_TRUE(equilibrate(foam, {}).converged());
    }
}

TEST(Collapse, KeepsTheOnlyOtherBubble) {
    Foam foam = honeycomb(1, 2);
    TopologyCounts counts;
    ASSERT_TRUE(collapse(foam, BubbleId{0}, counts));
    EXPECT_TRUE(is_valid(foam.network));
    EXPECT_EQ(foam.network.bubble_count(), 1U);
    EXPECT_EQ(foam.network.sides(BubbleId{1}), 6);
    EXPECT_NEAR(foam.target_areas[BubbleId{1}], 2.0, 1e-14);
}

// The film between two bubbles tears (T1) when one of them vanishes (T2); the other one is alone.
TEST(Collapse, OfABubbleInARaftOfTwoCountsBothEvents) {
    Foam foam = test::double_bubble(1.0, 1.0);
    TopologyCounts counts;
    ASSERT_TRUE(collapse(foam, BubbleId{0}, counts));
    EXPECT_EQ(counts.t1, 1);
    EXPECT_EQ(counts.t2, 1);
    EXPECT_EQ(foam.lone_bubbles.size(), 1U);
}

// The films of the only bubble can flip forever, but the bubble never has fewer than six sides.
TEST(Collapse, DoesNotTakeTheLastBubble) {
    Foam foam = test::single_bubble();
    TopologyCounts counts;
    EXPECT_FALSE(collapse(foam, BubbleId{0}, counts));
    EXPECT_EQ(counts.t2, 0);
    EXPECT_TRUE(is_valid(foam.network));
    EXPECT_EQ(foam.target_areas[BubbleId{0}], 1.0);
}

TEST(CollapseDue, RemovesOnlyDueBubbles) {
    Foam foam = honeycomb_around(3);
    foam.target_areas[kDying] = 0.005;
    foam.target_areas[BubbleId{10}] = 0.005;  // five sides: due only below 0.001
    const double total = total_target(foam);
    const TopologyCounts counts = collapse_due(foam, {.t2_area = 0.01});
    EXPECT_EQ(counts.t1, 0);
    EXPECT_EQ(counts.t2, 1);
    EXPECT_FALSE(foam.network.is_live(kDying));
    EXPECT_EQ(foam.network.bubble_count(), 15U);
    EXPECT_NEAR(total_target(foam), total, 1e-13);
}

TEST(CollapseDue, RemovesNeighborsInOneCall) {
    Foam foam = honeycomb_around(3);
    for (const BubbleId bubble : {kDying, BubbleId{10}, BubbleId{4}}) {
        foam.target_areas[bubble] = 0.0005;
    }
    const double total = total_target(foam);
    const TopologyCounts counts = collapse_due(foam, {.t2_area = 0.01});
    EXPECT_EQ(counts.t2, 3);
    EXPECT_TRUE(is_valid(foam.network));
    EXPECT_EQ(foam.network.bubble_count(), 13U);
    EXPECT_NEAR(total_target(foam), total, 1e-13);
}

// A time step in which large bubbles change little can take the target area of a small bubble far
// below zero. Its neighbors then lose gas. A neighbor that loses almost all its gas vanishes too.
TEST(CollapseDue, RemovesNeighborsWhoseGasIsUsedUp) {
    for (const BubbleId neighbor : {BubbleId{1}, BubbleId{6}, BubbleId{9}}) {
        Foam foam = honeycomb_around(3);
        foam.target_areas[kDying] = -0.3;
        foam.target_areas[neighbor] = 0.02;  // not due itself; its id is below or above kDying
        const double total = total_target(foam);
        EXPECT_EQ(collapse_due(foam, {.t2_area = 0.01}).t2, 2) << index_of(neighbor);
        EXPECT_FALSE(foam.network.is_live(neighbor));
        EXPECT_TRUE(is_valid(foam.network));
        EXPECT_NEAR(total_target(foam), total, 1e-13);
        for (const BubbleId bubble : foam.network.bubbles()) {
            EXPECT_GT(foam.target_areas[bubble], 0.0) << index_of(bubble);
        }
    }
}

// Both bubbles of a raft of two have lost more gas than they had. After the first has vanished, the
// second is a lone bubble without an area; its T2 has a position, too.
TEST(CollapseDue, RemovesARaftOfTwoWithoutGas) {
    Foam foam = test::double_bubble(1.0, 1.0);
    for (const BubbleId bubble : foam.network.bubbles()) {
        foam.target_areas[bubble] = -0.01;
    }
    EXPECT_EQ(collapse_due(foam, {}).t2, 2);
    EXPECT_EQ(foam.network.bubble_count() + foam.lone_bubbles.size(), 0U);
    for (const TopologyEvent& event : foam.events) {
        EXPECT_TRUE(event.position.allFinite());
    }
}

// Only the last bubble of a raft of three is due. Each of the others loses a third of its negative
// gas and is left with 0.03 - 0.2/3. When one of them vanishes from the raft of two, the last one
// becomes a lone bubble without gas.
TEST(CollapseDue, RemovesALoneBubbleThatALaterCollapseLeaves) {
    Foam foam = test::triple_bubble(0.03);
    foam.target_areas[BubbleId{2}] = -0.2;
    EXPECT_EQ(collapse_due(foam, {.t2_area = 0.01}).t2, 3);
    EXPECT_EQ(foam.network.bubble_count() + foam.lone_bubbles.size(), 0U);
    for (const TopologyEvent& event : foam.events) {
        EXPECT_TRUE(event.position.allFinite());
    }
}

TEST(CollapseDue, KeepsAFoamWithoutDueBubbles) {
    Foam foam = honeycomb(4, 4);
    const Foam before = foam;
    const TopologyCounts counts = collapse_due(foam, {});
    EXPECT_EQ(counts.t1 + counts.t2, 0);
    EXPECT_TRUE(test::are_same(foam, before));
}

}  // namespace
}  // namespace foam
