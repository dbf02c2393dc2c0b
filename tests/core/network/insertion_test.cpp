// SPDX-License-Identifier: Apache-2.0

#include "core/network/insertion.h"

#include "core/foam/random.h"
#include "core/network/t1.h"
#include "core/network/t2.h"
#include "tests/core/foams.h"
#include "tests/support/sample_foams.h"

#include <gtest/gtest.h>

#include <vector>

namespace foam {
namespace {

using test::is_valid;

// Expects that two networks have the same half-edges. The outgoing half-edges of junctions and the
// first half-edges of bubbles may differ.
void expect_same_shape(const Network& a, const Network& b) {
    ASSERT_EQ(a.film_slots(), b.film_slots());
    ASSERT_EQ(a.junction_slots(), b.junction_slots());
    for (std::size_t k = 0; k < 2 * a.film_slots(); ++k) {
        const auto h = id_at<HalfEdgeId>(k);
        EXPECT_EQ(a.tail(h), b.tail(h)) << k;
        EXPECT_EQ(a.left(h), b.left(h)) << k;
        EXPECT_EQ(a.next(h), b.next(h)) << k;
        EXPECT_TRUE(a.offset(h) == b.offset(h)) << k;
    }
    for (const BubbleId bubble : a.bubbles()) {
        EXPECT_EQ(a.sides(bubble), b.sides(bubble));
    }
}

// Expects that a T2 undoes an insertion. `insert` inserts a bubble into the network and returns it.
template <class Insert>
void expect_undone_by_t2(const Network& before, const Insert& insert) {
    Network network = before;
    const BubbleId bubble = insert(network);
    ASSERT_TRUE(is_valid(network));
    ASSERT_TRUE(can_vanish(network, bubble));
    vanish(network, bubble);
    ASSERT_TRUE(is_valid(network));
    network.renumber(network.live_ids());
    expect_same_shape(network, before);
}

std::vector<Network> networks() {
    std::vector<Network> networks{test::single_bubble().network};
    for (const int bubbles : {2, 3, 20}) {
        networks.push_back(test::raw_foam(bubbles, 5).network);
    }
    return networks;
}

TEST(InsertTriangle, GivesEachBubbleAroundItASide) {
    const Network before = test::raw_foam(40, 1).network;
    const JunctionId junction{11};
    Network network = before;
    const BubbleId triangle = insert_triangle(network, junction);
    EXPECT_TRUE(is_valid(network));
    EXPECT_EQ(network.sides(triangle), 3);
    EXPECT_EQ(network.tail(network.first(triangle)), junction);
    for (const HalfEdgeId h : before.leaving(junction)) {
        EXPECT_EQ(network.sides(before.left(h)), before.sides(before.left(h)) + 1);
    }
    EXPECT_EQ(network.junction_count(), before.junction_count() + 2);
    EXPECT_EQ(network.film_count(), before.film_count() + 3);
}

TEST(InsertTriangle, AtAnyJunctionIsUndoneByT2) {
    for (const Network& before : networks()) {
        for (const JunctionId junction : before.junctions()) {
            expect_undone_by_t2(
                before, [&](Network& network) { return insert_triangle(network, junction); });
        }
    }
}

TEST(InsertLens, GivesTheBubblesBesideItTwoSides) {
    const Network before = test::raw_foam(40, 1).network;
    const HalfEdgeId h{17};
    Network network = before;
    const BubbleId lens = insert_lens(network, h);
    EXPECT_TRUE(is_valid(network));
    EXPECT_EQ(network.sides(lens), 2);
    EXPECT_EQ(network.tail(network.first(lens)), network.tail(h));
    EXPECT_EQ(network.head(h), before.head(h));
    EXPECT_EQ(network.sides(before.left(h)), before.sides(before.left(h)) + 2);
    EXPECT_EQ(network.sides(before.right(h)), before.sides(before.right(h)) + 2);
    EXPECT_EQ(network.junction_count(), before.junction_count() + 2);
    EXPECT_EQ(network.film_count(), before.film_count() + 3);
}

TEST(InsertLens, OnAnyFilmIsUndoneByT2) {
    for (const Network& before : networks()) {
        for (std::size_t k = 0; k < 2 * before.film_slots(); ++k) {
            expect_undone_by_t2(before, [&](Network& network) {
                return insert_lens(network, id_at<HalfEdgeId>(k));
            });
        }
    }
}

// Random insertions, T1s and T2s in a network with dead slots.
TEST(Insertion, KeepsTheNetworkValidAmongOtherSurgery) {
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        Network network = test::raw_foam(6, seed).network;
        Random random(seed);
        for (int k = 0; k < 600; ++k) {
            const auto film = id_at<FilmId>(random.below(network.film_slots()));
            const auto bubble = id_at<BubbleId>(random.below(network.bubble_slots()));
            if (network.is_live(bubble) && can_vanish(network, bubble)) {
                vanish(network, bubble);
            }
            if (!network.is_live(film)) {
                continue;
            }
            const std::uint64_t choice = random.below(8);
            if (choice == 0 && network.bubble_count() < 12) {
                insert_triangle(network, network.tail(forward_side(film)));
            } else if (choice == 1 && network.bubble_count() < 12) {
                insert_lens(network, twin(forward_side(film)));
            } else if (can_flip(network, film)) {
                flip(network, film);
            }
            ASSERT_TRUE(is_valid(network)) << "seed " << seed << ", operation " << k;
        }
    }
}

}  // namespace
}  // namespace foam
