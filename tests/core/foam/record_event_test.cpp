// SPDX-License-Identifier: Apache-2.0

#include "core/foam/record_event.h"

#include "core/dynamics/collapse.h"
#include "core/dynamics/nucleation.h"
#include "core/dynamics/step.h"
#include "core/foam/honeycomb.h"
#include "core/foam/t1_rule.h"
#include "tests/core/equilibrium/crossing.h"
#include "tests/core/foams.h"
#include "tests/support/sample_foams.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace foam {
namespace {

long count(const Foam& foam, TopologyEventKind kind) {
    return std::count_if(foam.events.begin(), foam.events.end(), [&](const TopologyEvent& event) {
        return event.kind == kind;
    });
}

// Bubbles 5 and 6 are beside the film, bubbles 2 and 10 at its ends.
TEST(TopologyEvent, AFlipIsNotedAtTheMiddleWithItsFourBubbles) {
    test::Crossing c = test::crossing(60.0, 0.04);
    c.foam.time = 3.5;
    const Vec2 middle = middle_of(c.foam, c.film);
    flip_film(c.foam, c.film);
    ASSERT_EQ(c.foam.events.size(), 1U);
    TopologyEvent& event = c.foam.events.front();
    EXPECT_EQ(event.kind, TopologyEventKind::T1);
    EXPECT_EQ(event.time, 3.5);
    EXPECT_EQ(event.position, middle);
    std::sort(event.bubbles.begin(), event.bubbles.end());
    EXPECT_EQ(event.bubbles, (std::vector<BubbleIdentity>{2, 5, 6, 10}));
}

// A new bubble is added at a junction of a honeycomb and then collapses. Both events are at the
// position of the junction, up to the size of the bubble.
TEST(TopologyEvent, ABirthAndAnEndAreNotedWithTheThreeAround) {
    Foam foam = honeycomb(4, 4);
    const JunctionId junction{7};
    const Vec2 position = foam.positions[junction];
    std::vector<BubbleIdentity> expected{16};
    for (const HalfEdgeId h : foam.network.leaving(junction)) {
        expected.push_back(foam.identities[foam.network.left(h)]);
    }
    std::sort(expected.begin(), expected.end());
    const auto bubble = nucleate_at_junction(foam, junction, 0.01);
    TopologyCounts counts;
    ASSERT_TRUE(collapse(foam, *bubble, counts));
    ASSERT_EQ(foam.events.size(), 2U);
    EXPECT_EQ(foam.events[0].kind, TopologyEventKind::Birth);
    EXPECT_EQ(foam.events[0].position, position);
    EXPECT_EQ(foam.events[1].kind, TopologyEventKind::T2);
    EXPECT_LT(foam.domain.nearest_copy(foam.events[1].position - position).norm(), 0.1);
    for (TopologyEvent& event : foam.events) {
        std::sort(event.bubbles.begin(), event.bubbles.end());
        EXPECT_EQ(event.bubbles, expected);
    }
}

// Events of substeps that were undone are not recorded.
TEST(TopologyEvent, AStepNotesAsManyAsItCounts) {
    Foam foam = test::polydisperse_foam(120, 4);
    foam.events.clear();
    const StepSummary summary = step(foam, 20.0, {});
    EXPECT_GT(summary.equilibrium.t1, 0);
    EXPECT_GT(summary.equilibrium.t2, 0);
    EXPECT_EQ(count(foam, TopologyEventKind::T1), summary.equilibrium.t1);
    EXPECT_EQ(count(foam, TopologyEventKind::T2), summary.equilibrium.t2);
    const std::vector<TopologyEvent> before = foam.events;
    step(foam, 5.0, {});
    ASSERT_GT(foam.events.size(), before.size());
    EXPECT_TRUE(std::equal(before.begin(), before.end(), foam.events.begin()));
    EXPECT_TRUE(std::is_sorted(foam.events.begin(),
                               foam.events.end(),
                               [](const auto& a, const auto& b) { return a.time < b.time; }));
}

TEST(TopologyEvent, ALoneBubblesEndIsNotedWhereItWas) {
    Foam foam = test::circles({{3, {1.5, -2.0}, 0.001}, {4, {9.0, 0.0}, 2.0}});
    EXPECT_EQ(collapse_due(foam, {}).t2, 1);
    ASSERT_EQ(foam.events.size(), 1U);
    EXPECT_EQ(foam.events[0], (TopologyEvent{TopologyEventKind::T2, 0.0, {1.5, -2.0}, {3}}));
}

// The ghost is not among the bubbles of an event, for example when a film tears or a hole closes.
TEST(TopologyEvent, TheGhostIsNoBubble) {
    Foam foam = test::patch_foam(60, 3);
    foam.events.clear();
    step(foam, 30.0, {});
    EXPECT_GT(foam.events.size(), 0U);
    for (const TopologyEvent& event : foam.events) {
        for (const BubbleIdentity bubble : event.bubbles) {
            EXPECT_LT(bubble, foam.next_identity);
        }
    }
}

}  // namespace
}  // namespace foam
