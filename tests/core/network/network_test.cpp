// SPDX-License-Identifier: Apache-2.0

#include "core/network/network.h"

#include "core/foam/foam.h"
#include "core/foam/honeycomb.h"
#include "core/network/t1.h"
#include "core/network/t2.h"
#include "tests/core/foams.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

namespace foam {
namespace {

using test::are_same;
using test::honeycomb_around;
using test::is_valid;

template <class Id>
std::vector<Id> listed(const LiveRange<Id>& range) {
    std::vector<Id> ids;
    for (const Id id : range) {
        ids.push_back(id);
    }
    return ids;
}

TEST(Ids, TheTwoSidesOfAFilmAreTwins) {
    const FilmId film{3};
    EXPECT_EQ(forward_side(film), HalfEdgeId{6});
    EXPECT_EQ(twin(HalfEdgeId{6}), HalfEdgeId{7});
    EXPECT_EQ(twin(HalfEdgeId{7}), HalfEdgeId{6});
    EXPECT_EQ(film_of(HalfEdgeId{6}), film);
    EXPECT_EQ(film_of(HalfEdgeId{7}), film);
    EXPECT_TRUE(is_forward(HalfEdgeId{6}));
    EXPECT_FALSE(is_forward(HalfEdgeId{7}));
}

TEST(LiveRange, SkipsTheDead) {
    Network network;
    for (int k = 0; k < 5; ++k) {
        network.add_bubble();
    }
    for (const BubbleId bubble : {BubbleId{0}, BubbleId{2}, BubbleId{4}}) {
        network.remove(bubble);
    }
    EXPECT_EQ(listed(network.bubbles()), (std::vector<BubbleId>{BubbleId{1}, BubbleId{3}}));
    EXPECT_EQ(network.bubble_count(), 2U);
    EXPECT_EQ(network.bubble_slots(), 5U);
    EXPECT_FALSE(network.is_live(BubbleId{4}));
}

TEST(LiveRange, IsEmptyWithoutLiveSlots) {
    Network network;
    EXPECT_TRUE(listed(network.films()).empty());
    network.remove(network.add_film());
    EXPECT_TRUE(listed(network.films()).empty());
}

TEST(Network, OffsetsOfTheTwoSidesAreOpposite) {
    Network network;
    const HalfEdgeId h = forward_side(network.add_film());
    network.set_offset(twin(h), {1, -2});
    EXPECT_TRUE(network.offset(twin(h)) == (LatticeOffset{1, -2}));
    EXPECT_TRUE(network.offset(h) == (LatticeOffset{-1, 2}));
}

// In a 4 x 4 honeycomb, bubbles are numbered along the rows, and rows from bottom to top. Odd rows
// are shifted to the right by half a hexagon.
TEST(Network, AroundGoesCounterClockwise) {
    const Network network = honeycomb(4, 4).network;
    std::vector<BubbleId> neighbors;
    for (const HalfEdgeId h : network.around(BubbleId{5})) {
        EXPECT_EQ(network.left(h), BubbleId{5});
        neighbors.push_back(network.right(h));
    }
    EXPECT_EQ(neighbors,
              (std::vector<BubbleId>{
                  BubbleId{6}, BubbleId{10}, BubbleId{9}, BubbleId{4}, BubbleId{1}, BubbleId{2}}));
}

TEST(Network, LeavingGoesClockwise) {
    const Foam foam = honeycomb(4, 4);
    for (const JunctionId junction : foam.network.junctions()) {
        const std::array<HalfEdgeId, 3> leaving = foam.network.leaving(junction);
        EXPECT_EQ(leaving[0], foam.network.outgoing(junction));
        for (std::size_t k = 0; k < 3; ++k) {
            EXPECT_EQ(foam.network.tail(leaving[k]), junction);
            const Vec2 here = chord(foam, leaving[k]);
            const Vec2 following = chord(foam, leaving[(k + 1) % 3]);
            EXPECT_LT(cross(here, following), 0.0);
        }
    }
}

TEST(Network, PreviousUndoesNext) {
    const Network network = honeycomb(3, 2).network;
    for (std::size_t k = 0; k < 2 * network.film_slots(); ++k) {
        const auto h = id_at<HalfEdgeId>(k);
        EXPECT_EQ(network.previous(network.next(h)), h);
    }
}

// A rebase replaces a junction by one of its lattice copies. If its position moves to the same
// copy, all chords stay the same.
TEST(Network, RebaseKeepsChords) {
    const Foam before = honeycomb(1, 2);  // films cross both borders of the torus' cell
    for (const JunctionId junction : before.network.junctions()) {
        Foam after = before;
        const LatticeOffset by{2, -3};
        after.network.rebase(junction, by);
        after.positions[junction] -= after.domain.translation(by);
        EXPECT_TRUE(is_valid(after.network));
        for (std::size_t k = 0; k < 2 * before.network.film_slots(); ++k) {
            const auto h = id_at<HalfEdgeId>(k);
            EXPECT_LT((chord(after, h) - chord(before, h)).norm(), 1e-14);
        }
    }
}

TEST(Network, RebaseBackIsTheSameNetwork) {
    const Network before = honeycomb(2, 2).network;
    Network after = before;
    after.rebase(JunctionId{3}, {1, 2});
    EXPECT_FALSE(are_same(before, after));
    after.rebase(JunctionId{3}, {-1, -2});
    EXPECT_TRUE(are_same(before, after));
}

// A move of a junction by a period changes offsets, a T1 changes connections.
TEST(Network, ComparesConnections) {
    const Foam foam = honeycomb(4, 4);
    Network moved = foam.network;
    moved.rebase(JunctionId{3}, {1, 0});
    EXPECT_TRUE(moved.is_connected_as(foam.network));
    flip(moved, FilmId{5});
    EXPECT_FALSE(moved.is_connected_as(foam.network));
}

TEST(Network, IsCompactWithoutDeadSlots) {
    Network network = honeycomb_around(3).network;
    EXPECT_TRUE(network.is_compact());
    vanish(network, BubbleId{5});
    EXPECT_FALSE(network.is_compact());
    network.renumber(network.live_ids());
    EXPECT_TRUE(network.is_compact());
}

// The ghost has to be the last bubble.
TEST(Network, IsNotCompactWithABubbleAfterTheGhost) {
    Network network;
    network.add_ghost();
    EXPECT_TRUE(network.is_compact());
    network.add_bubble();
    EXPECT_FALSE(network.is_compact());
}

TEST(Network, RenumberingADenseNetworkInItsOrderChangesNothing) {
    const Network before = honeycomb(3, 4).network;
    Network after = before;
    const Network::OldIds order = after.live_ids();
    after.renumber(order);
    EXPECT_TRUE(are_same(before, after));
    EXPECT_EQ(order.junctions, listed(before.junctions()));
    EXPECT_EQ(order.films, listed(before.films()));
    EXPECT_EQ(order.bubbles, listed(before.bubbles()));
}

TEST(Network, RenumberingInReverseOrderTwiceChangesNothing) {
    const Network before = honeycomb_around(3).network;
    Network after = before;
    for (int k = 0; k < 2; ++k) {
        Network::OldIds order = after.live_ids();
        std::ranges::reverse(order.junctions);
        std::ranges::reverse(order.films);
        std::ranges::reverse(order.bubbles);
        after.renumber(order);
        EXPECT_TRUE(is_valid(after));
        EXPECT_EQ(are_same(before, after), k == 1);
    }
}

// After a T2, the remaining elements have new ids in the old order, and all relations among them
// are the same.
TEST(Network, RenumberingKeepsEverything) {
    Network sparse = honeycomb_around(3).network;
    vanish(sparse, BubbleId{5});
    Network dense = sparse;
    const Network::OldIds order = dense.live_ids();
    dense.renumber(order);
    ASSERT_TRUE(is_valid(dense));
    EXPECT_EQ(order.bubbles, listed(sparse.bubbles()));
    EXPECT_EQ(dense.bubble_slots(), 15U);
    EXPECT_EQ(dense.film_slots(), 45U);
    EXPECT_EQ(dense.junction_slots(), 30U);
    const auto old_half_edge = [&](HalfEdgeId h) {
        const HalfEdgeId forward = forward_side(order.films[index_of(film_of(h))]);
        return is_forward(h) ? forward : twin(forward);
    };
    for (std::size_t k = 0; k < 2 * dense.film_slots(); ++k) {
        const auto h = id_at<HalfEdgeId>(k);
        const HalfEdgeId old = old_half_edge(h);
        EXPECT_EQ(old_half_edge(dense.next(h)), sparse.next(old));
        EXPECT_EQ(order.junctions[index_of(dense.tail(h))], sparse.tail(old));
        EXPECT_EQ(order.bubbles[index_of(dense.left(h))], sparse.left(old));
        EXPECT_TRUE(dense.offset(h) == sparse.offset(old));
    }
    for (const BubbleId bubble : dense.bubbles()) {
        const BubbleId old = order.bubbles[index_of(bubble)];
        EXPECT_EQ(dense.sides(bubble), sparse.sides(old));
        EXPECT_EQ(old_half_edge(dense.first(bubble)), sparse.first(old));
    }
}

}  // namespace
}  // namespace foam
