// SPDX-License-Identifier: Apache-2.0

#include "core/network/ghost_boundary.h"

#include "tests/core/foams.h"

#include <gtest/gtest.h>

#include <array>

namespace foam {
namespace {

constexpr std::size_t kBubbles = 3;

/// Three bubbles around a junction, without the ghost. Inner film k leads from the middle junction
/// to rim junction k. Outer film k leads from rim junction k to the next rim junction.
struct Rosette {
    Network network;
    std::array<FilmId, kBubbles> inner{};
    std::array<FilmId, kBubbles> outer{};
};

Rosette rosette() {
    Rosette rosette;
    Network& network = rosette.network;
    const JunctionId middle = network.add_junction();
    std::array<JunctionId, kBubbles> rim{};
    for (std::size_t k = 0; k < kBubbles; ++k) {
        rim[k] = network.add_junction();
        rosette.inner[k] = network.add_film();
        rosette.outer[k] = network.add_film();
    }
    for (std::size_t k = 0; k < kBubbles; ++k) {
        const std::size_t after = (k + 1) % kBubbles;
        const BubbleId bubble = network.add_bubble();
        const std::array<HalfEdgeId, 3> sides{forward_side(rosette.inner[k]),
                                              forward_side(rosette.outer[k]),
                                              twin(forward_side(rosette.inner[after]))};
        const std::array<JunctionId, 3> tails{middle, rim[k], rim[after]};
        for (std::size_t side = 0; side < sides.size(); ++side) {
            network.set_tail(sides[side], tails[side]);
            network.set_left(sides[side], bubble);
            network.set_next(sides[side], sides[(side + 1) % sides.size()]);
        }
        network.set_first(bubble, sides[0]);
        network.set_sides(bubble, 3);
    }
    return rosette;
}

TEST(AddGhostBoundary, MakesAValidNetwork) {
    Rosette r = rosette();
    add_ghost_boundary(r.network);
    EXPECT_TRUE(test::is_valid(r.network));
}

// The outer sides run clockwise around the bubbles: from rim junction k + 1 back to k, and on to k
// - 1.
TEST(AddGhostBoundary, LinksTheOuterSidesAroundTheGhost) {
    Rosette r = rosette();
    add_ghost_boundary(r.network);
    const BubbleId ghost = r.network.ghost();
    EXPECT_EQ(r.network.sides(ghost), 3);
    for (std::size_t k = 0; k < kBubbles; ++k) {
        const HalfEdgeId outside = twin(forward_side(r.outer[k]));
        const HalfEdgeId before = twin(forward_side(r.outer[(k + kBubbles - 1) % kBubbles]));
        EXPECT_EQ(r.network.left(outside), ghost);
        EXPECT_EQ(r.network.next(outside), before);
        EXPECT_TRUE(r.network.is_outer(r.outer[k]));
        EXPECT_FALSE(r.network.is_outer(r.inner[k]));
    }
}

TEST(AddGhostBoundary, GivesAnEmptyNetworkAGhostWithoutSides) {
    Network network;
    add_ghost_boundary(network);
    ASSERT_NE(network.ghost(), kNone<BubbleId>);
    EXPECT_EQ(network.sides(network.ghost()), 0);
}

}  // namespace
}  // namespace foam
