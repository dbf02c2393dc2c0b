// SPDX-License-Identifier: Apache-2.0

#include "core/reference/junction_coloring.h"

#include "core/foam/foam.h"
#include "core/foam/honeycomb.h"
#include "core/network/t2.h"
#include "tests/core/foams.h"
#include "tests/core/patches.h"
#include "tests/support/sample_foams.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

namespace foam {
namespace {

using Colors = std::vector<std::vector<JunctionId>>;

std::set<BubbleId> bubbles_of(const Network& network, JunctionId junction) {
    std::set<BubbleId> bubbles;
    for (const HalfEdgeId h : network.leaving(junction)) {
        if (network.left(h) != network.ghost()) {
            bubbles.insert(network.left(h));
        }
    }
    return bubbles;
}

std::set<JunctionId> junctions_of(const Network& network, BubbleId bubble) {
    std::set<JunctionId> junctions;
    for (const HalfEdgeId h : network.around(bubble)) {
        junctions.insert(network.tail(h));
    }
    return junctions;
}

void expect_no_shared_bubble(const Network& network, const std::vector<JunctionId>& color) {
    std::set<BubbleId> seen;
    for (const JunctionId junction : color) {
        for (const BubbleId bubble : bubbles_of(network, junction)) {
            EXPECT_TRUE(seen.insert(bubble).second) << "bubble " << index_of(bubble);
        }
    }
}

void expect_valid(const Network& network) {
    const Colors colors = color_junctions(network);
    std::set<JunctionId> seen;
    std::size_t largest = 0;
    for (const BubbleId bubble : network.bubbles()) {
        largest = std::max(largest, junctions_of(network, bubble).size());
    }
    for (const std::vector<JunctionId>& color : colors) {
        EXPECT_FALSE(color.empty());
        EXPECT_TRUE(std::is_sorted(color.begin(), color.end()));
        expect_no_shared_bubble(network, color);
        seen.insert(color.begin(), color.end());
    }
    EXPECT_GE(colors.size(), largest);
    EXPECT_EQ(seen.size(), network.junction_count());
    for (const JunctionId junction : network.junctions()) {
        EXPECT_EQ(seen.count(junction), 1U);
    }
}

TEST(JunctionColoring, SharesNoBubbleInAColor) {
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        expect_valid(test::raw_foam(200, seed).network);
    }
    expect_valid(test::equilibrated_foam(200, 1).network);
}

TEST(JunctionColoring, SharesNoBubbleOnTinyTori) {
    for (int bubbles = 2; bubbles <= 12; ++bubbles) {
        expect_valid(test::raw_foam(bubbles, 1).network);
    }
}

// The six junctions of the middle bubble need six colors. Junctions at the ghost need no further
// colors.
TEST(JunctionColoring, TakesNoColorForTheGhost) {
    const Network network = test::flower(1.0).network;
    expect_valid(network);
    EXPECT_EQ(color_junctions(network).size(), 6U);
}

// Both junctions are junctions of the only bubble.
TEST(JunctionColoring, GivesEveryJunctionOfASingleBubbleItsOwn) {
    EXPECT_EQ(color_junctions(test::single_bubble().network),
              (Colors{{JunctionId{0}}, {JunctionId{1}}}));
}

// A junction shares a bubble with at most 12 other junctions: 3 (6 - 1) = 15 in its three bubbles,
// of which its three neighbors are counted twice. A greedy coloring of a honeycomb therefore needs
// at most 13 colors. Any coloring needs at least 6.
TEST(JunctionColoring, TakesFewColorsForAHoneycomb) {
    const Colors colors = color_junctions(honeycomb(12, 12).network);
    EXPECT_GE(colors.size(), 6U);
    EXPECT_LE(colors.size(), 13U);
}

TEST(JunctionColoring, LeavesTheDeadOut) {
    Foam foam = test::honeycomb_around(3);
    vanish(foam.network, BubbleId{5});
    expect_valid(foam.network);
}

}  // namespace
}  // namespace foam
