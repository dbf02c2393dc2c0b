// SPDX-License-Identifier: Apache-2.0

#include "core/foam/frame.h"

#include "core/foam/honeycomb.h"
#include "core/foam/measure.h"
#include "core/network/t2.h"
#include "tests/core/foams.h"
#include "tests/support/sample_foams.h"

#include <gtest/gtest.h>

namespace foam {
namespace {

TEST(Frame, HoldsTheValuesOfTheFoam) {
    Foam foam = test::bent_foam(30, 1.0, 5);
    foam.time = 1.25;
    foam.film_tension = 0.5;
    foam.next_identity = 77;
    foam.identities[BubbleId{3}] = 76;
    const Frame frame = snapshot(foam, 12);
    EXPECT_EQ(frame.number, 12);
    EXPECT_EQ(frame.time, 1.25);
    EXPECT_EQ(frame.film_tension, 0.5);
    EXPECT_EQ(frame.domain.width, foam.domain.width);
    EXPECT_EQ(frame.domain.height, foam.domain.height);
    EXPECT_EQ(frame.positions, foam.positions);
    EXPECT_TRUE(test::are_same(frame.network, foam.network));
    ASSERT_EQ(frame.bubbles.size(), 30U);
    for (const BubbleId bubble : foam.network.bubbles()) {
        EXPECT_EQ(frame.bubbles[bubble].identity, foam.identities[bubble]);
        EXPECT_EQ(frame.bubbles[bubble].area, bubble_area(foam, bubble));
        EXPECT_EQ(frame.bubbles[bubble].target_area, foam.target_areas[bubble]);
        EXPECT_EQ(frame.bubbles[bubble].pressure, foam.pressures[bubble]);
    }
}

TEST(Frame, HoldsTheArcsOfBothSides) {
    const Foam foam = test::bent_foam(30, 1.0, 5);
    const Frame frame = snapshot(foam, 1);
    for (std::size_t k = 0; k < 2 * foam.network.film_slots(); ++k) {
        const auto h = id_at<HalfEdgeId>(k);
        // The chord of the other side is computed in another order of operations.
        EXPECT_NEAR(frame.arc(h).half_angle, film_arc(foam, h).half_angle, 1e-14);
        EXPECT_LT((frame.arc(h).chord - chord(foam, h)).norm(), 1e-14);
    }
}

TEST(Frame, HasNoDeadSlots) {
    Foam foam = test::honeycomb_around(3);
    vanish(foam.network, BubbleId{5});
    const Frame frame = snapshot(foam, 1);
    EXPECT_EQ(foam.network.bubble_slots(), 16U);  // the foam is unchanged
    EXPECT_TRUE(test::is_valid(frame.network));
    EXPECT_EQ(frame.network.bubble_slots(), 15U);
    EXPECT_EQ(frame.bubbles.size(), 15U);
    EXPECT_EQ(frame.arcs.size(), 45U);
    EXPECT_EQ(frame.positions.size(), 30U);
    EXPECT_EQ(frame.bubbles[BubbleId{5}].identity, 6U);
}

TEST(Frame, BecomesAFoamAgain) {
    for (const Foam& foam :
         {test::bent_foam(30, 1.0, 5),
          test::patch_foam(20, 3),
          test::circles({{.identity = 4, .center = {1.0, 2.0}, .target_area = 2.0}})}) {
        const Frame frame = snapshot(foam, 12);
        const Foam back = foam_of(frame);
        EXPECT_TRUE(test::are_same(back.network, foam.network));
        EXPECT_EQ(back.positions, foam.positions);
        EXPECT_EQ(back.pressures, foam.pressures);
        EXPECT_EQ(back.target_areas, foam.target_areas);
        EXPECT_EQ(back.identities, foam.identities);
        EXPECT_EQ(back.lone_bubbles, foam.lone_bubbles);
        EXPECT_EQ(energy(back), energy(foam));
        EXPECT_EQ(back.t1_armed.size(), foam.network.film_slots());
    }
}

TEST(Frame, AFoamOfAFrameHasUnusedIdentities) {
    const Foam foam = test::circles({{.identity = 4, .center = {1.0, 2.0}, .target_area = 2.0}});
    EXPECT_EQ(foam_of(snapshot(foam, 1)).next_identity, 5U);
    EXPECT_EQ(foam_of(snapshot(honeycomb(4, 4), 1)).next_identity, 16U);
}

}  // namespace
}  // namespace foam
