// SPDX-License-Identifier: Apache-2.0

#include "core/dynamics/unrest.h"

#include "core/foam/honeycomb.h"
#include "core/network/t1.h"
#include "tests/core/foams.h"

#include <gtest/gtest.h>

namespace foam {
namespace {

using Bubbles = std::vector<BubbleIdentity>;

// Returns the honeycomb after a T1 of the film between bubbles 5 and 6. The bubbles 5 and 6 lose
// each other as neighbors; the bubbles 2 and 9, which were beside the film's ends, become
// neighbors.
Foam flipped() {
    Foam foam = honeycomb(4, 4);
    flip(foam.network, film_of(test::side_between(foam.network, BubbleId{5}, BubbleId{6})));
    return foam;
}

Bubbles neighbors_lost_or_won() {
    Bubbles bubbles;
    const Foam before = honeycomb(4, 4);
    const Foam after = flipped();
    for (const BubbleId bubble : before.network.bubbles()) {
        if (before.network.sides(bubble) != after.network.sides(bubble)) {
            bubbles.push_back(before.identities[bubble]);
        }
    }
    return bubbles;
}

TEST(Unrest, ABubbleThatChangesInEveryCycleIsRestless) {
    Unrest unrest(honeycomb(4, 4));
    const Foam rest = honeycomb(4, 4);
    const Foam other = flipped();
    EXPECT_EQ(unrest.restless_bubbles(other), Bubbles{});  // the first cycles do not count
    EXPECT_EQ(unrest.restless_bubbles(rest), Bubbles{});
    EXPECT_EQ(unrest.restless_bubbles(other), Bubbles{});  // one change is not enough
    const Bubbles restless = unrest.restless_bubbles(rest);
    EXPECT_EQ(restless.size(), 4U);
    EXPECT_EQ(restless, neighbors_lost_or_won());
}

TEST(Unrest, ASingleChangeIsForgotten) {
    Unrest unrest(honeycomb(4, 4));
    const Foam rest = honeycomb(4, 4);
    for (int cycle = 0; cycle < 3; ++cycle) {
        EXPECT_EQ(unrest.restless_bubbles(rest), Bubbles{});
    }
    EXPECT_EQ(unrest.restless_bubbles(flipped()), Bubbles{});
    for (int cycle = 0; cycle < 4; ++cycle) {
        EXPECT_EQ(unrest.restless_bubbles(flipped()), Bubbles{});
    }
    EXPECT_EQ(unrest.restless_bubbles(rest), Bubbles{});
}

}  // namespace
}  // namespace foam
