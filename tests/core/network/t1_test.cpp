// SPDX-License-Identifier: Apache-2.0

#include "core/network/t1.h"

#include "core/foam/honeycomb.h"
#include "tests/core/foams.h"
#include "tests/support/sample_foams.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace foam {
namespace {

using test::honeycomb_around;
using test::insert_lens;
using test::is_valid;
using test::side_between;

FilmId film_between(const Network& network, std::size_t a, std::size_t b) {
    return film_of(side_between(network, id_at<BubbleId>(a), id_at<BubbleId>(b)));
}

// The film between bubbles 5 and 6 of a 4 x 4 honeycomb is vertical, with bubble 2 at its lower end
// and bubble 10 at its upper end. Its forward side was created with bubble 5, which is on its left.
// It therefore points up.
TEST(T1Site, NamesTheNeighborhood) {
    const Network network = honeycomb(4, 4).network;
    const T1Site site = t1_site(network, film_between(network, 5, 6));
    EXPECT_EQ(network.left(site.film), BubbleId{5});
    EXPECT_EQ(network.right(site.film), BubbleId{6});
    EXPECT_EQ(site.end_tail, BubbleId{2});
    EXPECT_EQ(site.end_head, BubbleId{10});
    EXPECT_EQ(network.right(site.before_left), BubbleId{2});
    EXPECT_EQ(network.right(site.after_left), BubbleId{10});
    EXPECT_EQ(network.right(site.before_right), BubbleId{10});
    EXPECT_EQ(network.right(site.after_right), BubbleId{2});
}

TEST(T1, PartsTheNeighborsAndJoinsTheEnds) {
    Network network = honeycomb(4, 4).network;
    const FilmId film = film_between(network, 5, 6);
    ASSERT_TRUE(can_flip(network, film));
    flip(network, film);
    EXPECT_TRUE(is_valid(network));
    EXPECT_EQ(network.left(forward_side(film)), BubbleId{10});
    EXPECT_EQ(network.right(forward_side(film)), BubbleId{2});
    EXPECT_EQ(network.sides(BubbleId{5}), 5);
    EXPECT_EQ(network.sides(BubbleId{6}), 5);
    EXPECT_EQ(network.sides(BubbleId{2}), 7);
    EXPECT_EQ(network.sides(BubbleId{10}), 7);
    for (const HalfEdgeId h : network.around(BubbleId{5})) {
        EXPECT_NE(network.right(h), BubbleId{6});
    }
}

TEST(T1, GivesEachEndTheOuterFilmsOfItsSide) {
    Network network = honeycomb(4, 4).network;
    const FilmId film = film_between(network, 5, 6);
    const T1Site site = t1_site(network, film);
    const JunctionId tail = network.tail(site.film);
    const JunctionId head = network.head(site.film);
    flip(network, film);
    EXPECT_EQ(network.tail(site.film), tail);
    EXPECT_EQ(network.head(site.before_left), tail);
    EXPECT_EQ(network.tail(site.after_left), tail);
    EXPECT_EQ(network.head(site.before_right), head);
    EXPECT_EQ(network.tail(site.after_right), head);
}

// After the second flip the forward side has bubble 6 on its left: the film has turned by 180
// degrees. All relations around it are the same as before.
TEST(T1, TwiceRestoresTheNeighborhoodTurnedRound) {
    const Network before = honeycomb(4, 4).network;
    Network after = before;
    const FilmId film = film_between(before, 5, 6);
    flip(after, film);
    flip(after, film);
    EXPECT_TRUE(is_valid(after));
    const T1Site old_site = t1_site(before, film);
    const T1Site new_site = t1_site(after, film);
    EXPECT_EQ(after.left(new_site.film), BubbleId{6});
    EXPECT_EQ(after.right(new_site.film), BubbleId{5});
    EXPECT_EQ(new_site.end_tail, old_site.end_head);
    EXPECT_EQ(new_site.end_head, old_site.end_tail);
    EXPECT_EQ(new_site.before_left, old_site.before_right);
    EXPECT_EQ(new_site.after_left, old_site.after_right);
    EXPECT_EQ(new_site.before_right, old_site.before_left);
    EXPECT_EQ(new_site.after_right, old_site.after_left);
    for (const BubbleId bubble : after.bubbles()) {
        EXPECT_EQ(after.sides(bubble), 6);
    }
}

TEST(T1, FourTimesRestoresEveryRelation) {
    const Network before = honeycomb(4, 4).network;
    for (const FilmId film : before.films()) {
        Network after = before;
        for (int k = 0; k < 4; ++k) {
            flip(after, film);
        }
        ASSERT_TRUE(is_valid(after));
        for (std::size_t k = 0; k < 2 * before.film_slots(); ++k) {
            const auto h = id_at<HalfEdgeId>(k);
            EXPECT_EQ(after.tail(h), before.tail(h));
            EXPECT_EQ(after.left(h), before.left(h));
            EXPECT_EQ(after.next(h), before.next(h));
        }
    }
}

TEST(T1, TakesATriangleToTwoSidesAndNoFurther) {
    Network network = honeycomb_around(3).network;
    ASSERT_EQ(network.sides(BubbleId{5}), 3);
    const FilmId film = film_between(network, 5, 6);
    ASSERT_TRUE(can_flip(network, film));
    flip(network, film);
    EXPECT_TRUE(is_valid(network));
    EXPECT_EQ(network.sides(BubbleId{5}), 2);
    EXPECT_FALSE(can_flip(network, film_between(network, 5, 9)));
    EXPECT_FALSE(can_flip(network, film_between(network, 5, 1)));
}

// A lens is inserted into the film between bubbles 5 and 6, and a second lens into the film between
// the first lens and bubble 6. The neighbors of the first lens are then 5, 6, the second lens, and
// 6 again. Its film with 5 has the same copy of bubble 6 at both ends. After a flip, bubble 6 would
// be on both sides of this film.
TEST(T1, RejectsEndsThatAreOneCopyOfABubble) {
    Foam foam = honeycomb(4, 4);
    const BubbleId outer = insert_lens(foam, film_between(foam.network, 5, 6), 0.5);
    const FilmId with_q = film_of(side_between(foam.network, outer, BubbleId{6}));
    const BubbleId inner = insert_lens(foam, with_q, 0.5);
    const Network& network = foam.network;
    ASSERT_TRUE(is_valid(network));
    ASSERT_EQ(network.sides(outer), 4);
    const FilmId with_p = film_of(side_between(network, outer, BubbleId{5}));
    const T1Site site = t1_site(network, with_p);
    EXPECT_EQ(site.end_tail, BubbleId{6});
    EXPECT_EQ(site.end_head, BubbleId{6});
    EXPECT_FALSE(can_flip(network, with_p));
    EXPECT_FALSE(can_flip(network, film_of(side_between(network, outer, inner))));
    EXPECT_TRUE(can_flip(network, film_of(side_between(network, outer, BubbleId{6}))));
}

// With one bubble per row, the film between a bubble and its own copy has two copies of the other
// bubble at its ends, a period apart. After the flip, the film separates these copies, and the
// first bubble has lost two sides.
TEST(T1, TakesEndsThatAreDifferentCopies) {
    Network network = honeycomb(1, 2).network;
    const FilmId film = film_between(network, 0, 0);
    const T1Site site = t1_site(network, film);
    ASSERT_EQ(site.end_tail, BubbleId{1});
    ASSERT_EQ(site.end_head, BubbleId{1});
    ASSERT_TRUE(can_flip(network, film));
    flip(network, film);
    EXPECT_TRUE(is_valid(network));
    EXPECT_EQ(network.sides(BubbleId{0}), 4);
    EXPECT_EQ(network.sides(BubbleId{1}), 8);
}

// The bubble loses two sides beside the film and gains two sides at its ends.
TEST(T1, LeavesTheOnlyBubbleOfATorusItsSixSides) {
    const Network network = test::single_bubble().network;
    for (const FilmId film : network.films()) {
        EXPECT_TRUE(can_flip(network, film));
        Network flipped = network;
        flip(flipped, film);
        EXPECT_TRUE(is_valid(flipped));
        EXPECT_EQ(flipped.sides(BubbleId{0}), 6);
    }
}

}  // namespace
}  // namespace foam
