// SPDX-License-Identifier: Apache-2.0

#include "core/network/t2.h"

#include "core/foam/honeycomb.h"
#include "core/network/t1.h"
#include "tests/core/foams.h"
#include "tests/support/sample_foams.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace foam {
namespace {

using test::honeycomb_around;
using test::insert_lens;
using test::is_valid;
using test::side_between;

constexpr BubbleId kTriangle{5};

std::vector<int> sides_of(const Network& network, const std::vector<std::size_t>& bubbles) {
    std::vector<int> sides;
    sides.reserve(bubbles.size());
    for (const std::size_t bubble : bubbles) {
        sides.push_back(network.sides(id_at<BubbleId>(bubble)));
    }
    return sides;
}

std::vector<BubbleId> sorted(std::vector<BubbleId> bubbles) {
    std::sort(bubbles.begin(), bubbles.end());
    return bubbles;
}

// Each of the three flips takes a side from bubble 5 and from the neighbor across the film, and
// gives a side to each of the two neighbors at its ends. Bubbles 10, 4 and 2 then have 5 sides, and
// bubbles 6, 9 and 1 have 8 sides.
TEST(T2, TheTriangleHasTheSidesItShould) {
    const Network network = honeycomb_around(3).network;
    ASSERT_TRUE(is_valid(network));
    EXPECT_EQ(network.sides(kTriangle), 3);
    EXPECT_EQ(sides_of(network, {10, 4, 2}), (std::vector<int>{5, 5, 5}));
    EXPECT_EQ(sides_of(network, {6, 9, 1}), (std::vector<int>{8, 8, 8}));
}

TEST(T2, ThreeSidedBubbleBecomesAJunction) {
    Network network = honeycomb_around(3).network;
    const JunctionId remaining = network.tail(network.first(kTriangle));
    ASSERT_TRUE(can_vanish(network, kTriangle));
    const Vanished vanished = vanish(network, kTriangle);
    EXPECT_TRUE(is_valid(network));
    EXPECT_EQ(vanished.junction, remaining);
    EXPECT_EQ(vanished.film, kNone<FilmId>);
    EXPECT_FALSE(network.is_live(kTriangle));
    EXPECT_EQ(network.bubble_count(), 15U);
    EXPECT_EQ(network.film_count(), 45U);
    EXPECT_EQ(network.junction_count(), 30U);
    EXPECT_EQ(sides_of(network, {6, 9, 1}), (std::vector<int>{7, 7, 7}));
    EXPECT_EQ(sides_of(network, {10, 4, 2}), (std::vector<int>{5, 5, 5}));
}

TEST(T2, TheJunctionJoinsTheThreeNeighbors) {
    Network network = honeycomb_around(3).network;
    const Vanished vanished = vanish(network, kTriangle);
    std::vector<BubbleId> around;
    for (const HalfEdgeId h : network.leaving(vanished.junction)) {
        around.push_back(network.left(h));
    }
    EXPECT_EQ(sorted(around), (std::vector<BubbleId>{BubbleId{1}, BubbleId{6}, BubbleId{9}}));
    EXPECT_EQ(sorted(vanished.neighbors), sorted(around));
}

// After one more flip, bubble 5 has two sides, and its neighbors are 9 and 1. When it vanishes, a
// film between 9 and 1 is left. The numbers of sides are the same as after a T2 with three sides.
TEST(T2, TwoSidedBubbleBecomesAFilm) {
    Network network = honeycomb_around(3).network;
    flip(network, film_of(side_between(network, kTriangle, BubbleId{6})));
    ASSERT_EQ(sides_of(network, {5, 6, 9, 1}), (std::vector<int>{2, 7, 9, 9}));
    ASSERT_TRUE(can_vanish(network, kTriangle));
    const Vanished vanished = vanish(network, kTriangle);
    EXPECT_TRUE(is_valid(network));
    EXPECT_EQ(vanished.junction, kNone<JunctionId>);
    const HalfEdgeId h = forward_side(vanished.film);
    EXPECT_EQ(sorted({network.left(h), network.right(h)}),
              (std::vector<BubbleId>{BubbleId{1}, BubbleId{9}}));
    EXPECT_EQ(sorted(vanished.neighbors), (std::vector<BubbleId>{BubbleId{1}, BubbleId{9}}));
    EXPECT_EQ(network.bubble_count(), 15U);
    EXPECT_EQ(network.film_count(), 45U);
    EXPECT_EQ(network.junction_count(), 30U);
    EXPECT_EQ(sides_of(network, {6, 9, 1}), (std::vector<int>{7, 7, 7}));
}

// A lens is inserted into each film in turn, also into films that cross the border of the torus'
// cell. When it vanishes, the honeycomb and the chord of the film are the same as before.
TEST(T2, UndoesTheInsertionOfALens) {
    const Foam before = honeycomb(2, 2);
    for (const FilmId film : before.network.films()) {
        Foam foam = before;
        const BubbleId lens = insert_lens(foam, film, 0.5);
        ASSERT_TRUE(is_valid(foam.network));
        const Vanished vanished = vanish(foam.network, lens);
        EXPECT_TRUE(is_valid(foam.network));
        for (const BubbleId bubble : foam.network.bubbles()) {
            EXPECT_EQ(foam.network.sides(bubble), 6);
        }
        const Vec2 old_chord = chord(before, forward_side(film));
        const Vec2 new_chord = chord(foam, forward_side(vanished.film));
        EXPECT_LT(std::min((new_chord - old_chord).norm(), (new_chord + old_chord).norm()), 1e-14);
    }
}

// The films at the corners of a vanished bubble keep their outer ends, relative to the remaining
// junction.
TEST(T2, OuterFilmsKeepTheirFarEnds) {
    for (std::size_t shift = 0; shift < 3; ++shift) {
        Foam foam = honeycomb_around(3);
        Network& network = foam.network;
        const std::vector<HalfEdgeId> loop = network.around(kTriangle);
        network.set_first(kTriangle, loop[shift]);
        const Vec2 remaining = foam.positions[network.tail(loop[shift])];
        std::vector<Vec2> far_ends;
        Vec2 at = remaining;
        for (const HalfEdgeId h : network.around(kTriangle)) {
            far_ends.emplace_back(at + chord(foam, network.next(twin(h))));
            at += chord(foam, h);
        }
        const Vanished vanished = vanish(network, kTriangle);
        for (const HalfEdgeId h : network.leaving(vanished.junction)) {
            const Vec2 end = remaining + chord(foam, h);
            const bool is_known = std::any_of(far_ends.begin(), far_ends.end(), [&](const Vec2& p) {
                return (p - end).norm() < 1e-14;
            });
            EXPECT_TRUE(is_known);
        }
    }
}

TEST(T2, RejectsBubblesOfFourSidesAndMore) {
    Network network = honeycomb(4, 4).network;
    for (int sides = 6; sides >= 4; --sides) {
        EXPECT_FALSE(can_vanish(network, kTriangle)) << sides;
        flip(network, film_of(network.first(kTriangle)));
    }
    EXPECT_EQ(network.sides(kTriangle), 3);
    EXPECT_TRUE(can_vanish(network, kTriangle));
}

}  // namespace
}  // namespace foam
