// SPDX-License-Identifier: Apache-2.0

#include "core/equilibrium/unknowns.h"

#include "core/network/t2.h"
#include "tests/core/foams.h"

#include <gtest/gtest.h>

namespace foam {
namespace {

// Bubble 5 and two of its three junctions are removed, so that the rows of later elements are
// lower.
TEST(Unknowns, CountTheLivingByIncreasingId) {
    Network network = test::honeycomb_around(3).network;
    vanish(network, BubbleId{5});
    const Unknowns unknowns = all_unknowns(network);
    EXPECT_EQ(unknowns.junctions.size(), 30U);
    EXPECT_EQ(unknowns.bubbles.size(), 15U);
    EXPECT_EQ(unknowns.films.size(), 45U);
    EXPECT_EQ(unknowns.size(), 2 * 30 + 15);
    EXPECT_EQ(unknowns.pressure_row(BubbleId{4}), 60 + 4);
    EXPECT_EQ(unknowns.pressure_row(BubbleId{6}), 60 + 5);
    EXPECT_EQ(unknowns.bubble_rank[BubbleId{5}], -1);
    int row = 0;
    for (const JunctionId junction : network.junctions()) {
        EXPECT_EQ(unknowns.position_row(junction), row);
        row += 2;
    }
}

}  // namespace
}  // namespace foam
