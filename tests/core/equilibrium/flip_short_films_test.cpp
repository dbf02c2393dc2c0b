// SPDX-License-Identifier: Apache-2.0

#include "core/equilibrium/flip_short_films.h"

#include "core/foam/rafts.h"
#include "core/foam/t1_rule.h"
#include "tests/core/equilibrium/crossing.h"
#include "tests/core/foams.h"
#include "tests/core/patches.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace foam {
namespace {

using test::Crossing;
using test::crossing;

struct Call {
    FilmId film;
    FourBubbles around;
    bool changed;
};

struct Outcome {
    int t1 = 0;
    std::vector<Call> calls;
};

Outcome run(Foam& foam, Unknowns& part) {
    Outcome result;
    result.t1 =
        flip_short_films(foam, part, {}, [&](FilmId film, const FourBubbles& around, bool changed) {
            result.calls.push_back({film, around, changed});
        });
    return result;
}

// The short film of a crossing separates bubbles 5 and 6; bubbles 2 and 10 are at its ends.
TEST(FlipShortFilms, FlipsAndReportsAFilmThatStaysOpen) {
    Crossing c = crossing(60.0, 0.04);
    Foam expected = c.foam;
    ASSERT_TRUE(apply_t1_rule(expected, c.film, {}));
    Unknowns part = all_unknowns(c.foam.network);
    const Outcome result = run(c.foam, part);
    EXPECT_EQ(result.t1, 1);
    ASSERT_EQ(result.calls.size(), 1U);
    EXPECT_EQ(result.calls.front().film, c.film);
    EXPECT_TRUE(result.calls.front().changed);
    FourBubbles around = result.calls.front().around;
    std::sort(around.begin(), around.end());
    EXPECT_EQ(around, (FourBubbles{BubbleId{2}, BubbleId{5}, BubbleId{6}, BubbleId{10}}));
    EXPECT_TRUE(test::are_same(c.foam, expected));
}

TEST(FlipShortFilms, ReportsAShortFilmThatDoesNotFlip) {
    Crossing c = crossing(25.0, 0.04);
    const Foam before = c.foam;
    Unknowns part = all_unknowns(c.foam.network);
    const Outcome result = run(c.foam, part);
    EXPECT_EQ(result.t1, 0);
    ASSERT_EQ(result.calls.size(), 1U);
    EXPECT_FALSE(result.calls.front().changed);
    EXPECT_TRUE(test::are_same(c.foam, before));
}

TEST(FlipShortFilms, IgnoresLongFilms) {
    Crossing c = crossing(60.0, 0.06);
    Unknowns part = all_unknowns(c.foam.network);
    EXPECT_TRUE(run(c.foam, part).calls.empty());
}

// Bends the films of the hole of a ring so that bubbles overlap in it, and returns one of them. The
// test Rafts.BubblesOverlapInAHole shows that a half angle of 2 is enough.
FilmId fill_hole(Foam& ring) {
    FilmId found = kNone<FilmId>;
    for (const FilmId film : ring.network.films()) {
        const HalfEdgeId h = forward_side(film);
        if (ring.network.is_outer(film)) {
            set_half_angle(ring, h, ring.network.left(h) == ring.network.ghost() ? -2.2 : 2.2);
            found = is_overlapping_hole(ring, film) ? film : found;
        }
    }
    return found;
}

// The pulls would close the flipped film again, but they are not compared at such a hole.
TEST(FlipShortFilms, FlipsOnlyShortFilmsOfAHoleInWhichBubblesOverlap) {
    Foam foam = test::ring();
    const FilmId film = fill_hole(foam);
    Unknowns part = all_unknowns(foam.network);
    EXPECT_TRUE(run(foam, part).calls.empty());
    const HalfEdgeId h = forward_side(film);
    place_junction(foam,
                   foam.network.head(h),
                   foam.positions[foam.network.tail(h)] + 0.04 * chord(foam, h).normalized());
    ASSERT_TRUE(is_overlapping_hole(foam, film));
    ASSERT_FALSE(would_stay_open(foam, film));
    EXPECT_EQ(run(foam, part).t1, 1);
    EXPECT_TRUE(test::is_valid(foam.network));
}

// Only one end of the film is a junction of bubble 2, but both ends are junctions of bubble 5.
TEST(FlipShortFilms, IgnoresFilmsThatLeaveThePart) {
    for (const BubbleId bubble : {BubbleId{2}, BubbleId{5}}) {
        Crossing c = crossing(60.0, 0.04);
        const std::vector<BubbleId> bubbles{bubble};
        Unknowns part = unknowns_around(c.foam.network, bubbles);
        ASSERT_TRUE(std::count(part.films.begin(), part.films.end(), c.film) == 1);
        EXPECT_EQ(run(c.foam, part).t1, bubble == BubbleId{5} ? 1 : 0);
    }
}

// The middle film of a row of four bubbles tears. The film and its two junctions are removed, and
// the two outer films on each side become one.
TEST(FlipShortFilms, RemovesVanishedElementsFromThePart) {
    Foam foam = test::chain();
    const FilmId film = film_of(test::side_between(foam.network, BubbleId{1}, BubbleId{2}));
    const HalfEdgeId h = forward_side(film);
    const Vec2 middle = middle_of(foam, film);
    const Vec2 half = 0.01 * chord(foam, h).normalized();
    place_junction(foam, foam.network.tail(h), middle - half);
    place_junction(foam, foam.network.head(h), middle + half);
    Unknowns part = all_unknowns(foam.network);
    const std::size_t junctions = part.junctions.size();
    const std::size_t films = part.films.size();
    EXPECT_EQ(run(foam, part).t1, 1);
    EXPECT_TRUE(test::is_valid(foam.network));
    EXPECT_EQ(part.junctions.size(), junctions - 2);
    EXPECT_EQ(part.films.size(), films - 3);
    EXPECT_EQ(part.bubbles.size(), 4U);
    for (const JunctionId junction : part.junctions) {
        EXPECT_TRUE(foam.network.is_live(junction));
    }
    for (const FilmId left : part.films) {
        EXPECT_TRUE(foam.network.is_live(left));
    }
}

}  // namespace
}  // namespace foam
