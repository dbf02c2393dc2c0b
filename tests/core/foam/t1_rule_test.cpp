// SPDX-License-Identifier: Apache-2.0

#include "core/foam/t1_rule.h"

#include "core/foam/honeycomb.h"
#include "core/foam/measure.h"
#include "core/network/t1.h"
#include "tests/core/equilibrium/crossing.h"
#include "tests/core/foams.h"
#include "tests/support/sample_foams.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace foam {
namespace {

using test::Crossing;
using test::crossing;
using test::is_valid;

constexpr double kRounding = 1e-14;

// Returns the distance between two points on the torus.
double distance(const Domain& domain, const Vec2& a, const Vec2& b) {
    const Vec2 apart = a - b;
    return Vec2(std::remainder(apart.x(), domain.width), std::remainder(apart.y(), domain.height))
        .norm();
}

TEST(T1Length, IsTheThresholdWhereBubblesAreLarge) {
    Crossing c = crossing(60.0, 0.04);
    EXPECT_DOUBLE_EQ(t1_distance_at(c.foam, c.film, {.t1_distance = 0.05}), 0.05);
    c.foam.target_areas[BubbleId{5}] = 9.0;
    EXPECT_DOUBLE_EQ(t1_distance_at(c.foam, c.film, {.t1_distance = 0.05}), 0.05);
}

// Bubbles 5 and 6 are beside the film, bubbles 2 and 10 at its ends. Bubble 4 does not touch it.
TEST(T1Length, ScalesWithTheSmallestOfTheFourBubbles) {
    for (const std::size_t bubble : {5U, 6U, 2U, 10U}) {
        Crossing c = crossing(60.0, 0.04);
        c.foam.target_areas[id_at<BubbleId>(bubble)] = 0.25;
        EXPECT_DOUBLE_EQ(t1_distance_at(c.foam, c.film, {.t1_distance = 0.05}), 0.025) << bubble;
        EXPECT_DOUBLE_EQ(collapsed_length(c.foam, c.film, {.t1_distance = 0.05}), 0.00125);
    }
    Crossing c = crossing(60.0, 0.04);
    c.foam.target_areas[BubbleId{4}] = 0.25;
    EXPECT_DOUBLE_EQ(t1_distance_at(c.foam, c.film, {.t1_distance = 0.05}), 0.05);
}

TEST(T1Length, IsATenthForADisarmedFilm) {
    Crossing c = crossing(60.0, 0.04);
    c.foam.t1_armed[c.film] = 0;
    EXPECT_DOUBLE_EQ(t1_distance_at(c.foam, c.film, {.t1_distance = 0.05}), 0.005);
    EXPECT_DOUBLE_EQ(collapsed_length(c.foam, c.film, {.t1_distance = 0.05}), 0.0025);
}

// 2 sin(angle) > 1 for angles above 30 degrees. A film of length 1e-6 changes the directions of the
// adjacent films by no more than that.
TEST(WouldStayOpen, IsTrueFromThirtyDegreesOn) {
    const Crossing below = crossing(29.99, 1e-6);
    const Crossing above = crossing(30.01, 1e-6);
    EXPECT_FALSE(would_stay_open(below.foam, below.film));
    EXPECT_TRUE(would_stay_open(above.foam, above.film));
}

TEST(WouldStayOpen, IsTrueForAPointFromThirtyDegreesOn) {
    const Crossing below = crossing(29.99, 0.0);
    const Crossing above = crossing(30.01, 0.0);
    EXPECT_FALSE(would_stay_open(below.foam, below.film));
    EXPECT_TRUE(would_stay_open(above.foam, above.film));
}

// Bubbles 5 and 6, above and below the film, have a lower pressure than bubbles 2 and 10. The
// adjacent films, of chord 0.6 and with s = 0.3 delta = sin(10 degrees), bulge toward 5 and 6.
// Their tangents turn by 10 degrees away from the line of the film.
TEST(WouldStayOpen, FollowsTheTangentsOfTheArcs) {
    Crossing c = crossing(25.0, 1e-6);
    const double delta = std::sin(10.0 * std::acos(-1.0) / 180.0) / 0.3;
    EXPECT_FALSE(would_stay_open(c.foam, c.film));
    c.foam.pressures[BubbleId{2}] = delta;
    c.foam.pressures[BubbleId{10}] = delta;
    EXPECT_TRUE(would_stay_open(c.foam, c.film));
    c.foam.pressures[BubbleId{2}] = -delta;
    c.foam.pressures[BubbleId{10}] = -delta;
    EXPECT_FALSE(would_stay_open(c.foam, c.film));
}

TEST(FlipFilm, TurnsTheFilmAboutItsMiddle) {
    const Foam before = honeycomb(3, 4);
    for (const FilmId film : before.network.films()) {
        Foam foam = before;
        const Vec2 old_chord = chord(before, forward_side(film));
        flip_film(foam, film);
        const Vec2 new_chord = chord(foam, forward_side(film));
        EXPECT_TRUE(is_valid(foam.network));
        EXPECT_NEAR(new_chord.norm(), old_chord.norm(), kRounding);
        EXPECT_NEAR(new_chord.dot(old_chord), 0.0, kRounding);
        EXPECT_LT(distance(foam.domain, middle_of(foam, film), middle_of(before, film)), kRounding);
        EXPECT_EQ(foam.t1_armed[film], 0);
    }
}

// The polygons still cover the torus without gaps after a flip: the outer ends of the adjacent
// films do not move.
TEST(FlipFilm, KeepsTheOuterFilmsWhereTheyAre) {
    const Foam before = test::raw_foam(12, 3);
    for (const FilmId film : before.network.films()) {
        if (!can_flip(before.network, film)) {
            continue;
        }
        Foam foam = before;
        flip_film(foam, film);
        double total = 0.0;
        for (const BubbleId bubble : foam.network.bubbles()) {
            total += polygon_area(foam, bubble);
        }
        EXPECT_NEAR(total, foam.domain.area(), 1e-13 * foam.domain.area());
        for (const JunctionId junction : foam.network.junctions()) {
            EXPECT_TRUE(foam.domain.cell_of(foam.positions[junction]) == (LatticeOffset{0, 0}));
        }
    }
}

// Each flip turns the forward side clockwise by 90 degrees. After two flips it is reversed. After
// four flips all chords are as before.
TEST(FlipFilm, FourTimesIsAFullTurn) {
    const Foam before = honeycomb(3, 4);
    for (const FilmId film : before.network.films()) {
        Foam foam = before;
        flip_film(foam, film);
        flip_film(foam, film);
        const Vec2 reversed_chord = chord(foam, forward_side(film));
        EXPECT_LT((reversed_chord + chord(before, forward_side(film))).norm(), kRounding);
        flip_film(foam, film);
        flip_film(foam, film);
        for (const FilmId other : foam.network.films()) {
            const HalfEdgeId h = forward_side(other);
            EXPECT_LT((chord(foam, h) - chord(before, h)).norm(), 2.0 * kRounding);
        }
    }
}

// The adjacent films of a crossing pull with 2 cos(angle) along the film and with 2 sin(angle)
// across it. Below 45 degrees the film keeps its direction, above 45 degrees it flips.
TEST(ReopenFilm, OpensInTheDirectionThatPullsHardest) {
    for (const double degrees : {10.0, 30.0, 44.0}) {
        Crossing c = crossing(degrees, 1e-9);
        EXPECT_FALSE(reopen_film(c.foam, c.film, 0.02)) << degrees;
        EXPECT_LT((chord(c.foam, forward_side(c.film)) - Vec2(0.02, 0.0)).norm(), 1e-8);
        EXPECT_EQ(c.foam.t1_armed[c.film], 1);
    }
    for (const double degrees : {46.0, 60.0, 80.0}) {
        Crossing c = crossing(degrees, 1e-9);
        EXPECT_TRUE(reopen_film(c.foam, c.film, 0.02)) << degrees;
        // The chord leads from the side of bubble 5, above, to the side of bubble 6.
        EXPECT_LT((chord(c.foam, forward_side(c.film)) - Vec2(0.0, -0.02)).norm(), 1e-8);
        EXPECT_EQ(c.foam.t1_armed[c.film], 0);
    }
}

TEST(ReopenFilm, KeepsTheMiddleAndTheNetworkValid) {
    for (const double degrees : {30.0, 60.0}) {
        for (const double length : {0.0, 1e-12, 0.001}) {
            Crossing c = crossing(degrees, length);
            reopen_film(c.foam, c.film, 0.02);
            EXPECT_TRUE(is_valid(c.foam.network));
            EXPECT_NEAR(chord(c.foam, forward_side(c.film)).norm(), 0.02, kRounding);
            EXPECT_LT((middle_of(c.foam, c.film) - c.middle).norm(), kRounding);
        }
    }
}

// At each end of a film of a lens, the outer film pulls along the chord, and the other film of the
// lens makes 60 degrees with the chord. The pull along the chord is 1 - cos 60 = 0.5, the pull
// across it sin 60 = 0.87. The film cannot flip, because the lens would keep only one side.
TEST(ReopenFilm, OpensAlongItselfIfItCannotFlip) {
    Foam foam = honeycomb(4, 4);
    const BubbleId lens = test::insert_lens(foam, FilmId{0}, 0.5);
    const FilmId film = film_of(foam.network.first(lens));
    const Vec2 before = chord(foam, forward_side(film));
    ASSERT_FALSE(can_flip(foam.network, film));
    EXPECT_FALSE(reopen_film(foam, film, 0.02));
    EXPECT_EQ(foam.network.sides(lens), 2);
    EXPECT_LT((chord(foam, forward_side(film)) - 0.02 * before.normalized()).norm(), kRounding);
}

// With straight films, the other film of the lens pulls back with the same force as the outer film.
// There is no pull in any direction.
TEST(ReopenFilm, HasTheGivenLengthWithoutPulls) {
    Foam foam = honeycomb(4, 4);
    const BubbleId lens = test::insert_lens(foam, FilmId{0}, 0.5);
    foam.pressures[lens] = 0.0;  // as in all other bubbles
    const FilmId film = film_of(foam.network.first(lens));
    EXPECT_FALSE(reopen_film(foam, film, 0.02));
    EXPECT_NEAR(chord(foam, forward_side(film)).norm(), 0.02, kRounding);
}

TEST(ApplyT1Rule, LeavesAFilmAboveTheDistance) {
    Crossing c = crossing(60.0, 0.0501);
    const Foam before = c.foam;
    EXPECT_FALSE(apply_t1_rule(c.foam, c.film, {}));
    EXPECT_TRUE(test::are_same(c.foam, before));
}

TEST(ApplyT1Rule, FlipsAShortFilmThatStaysOpen) {
    Crossing c = crossing(60.0, 0.0499);
    EXPECT_TRUE(apply_t1_rule(c.foam, c.film, {}));
    EXPECT_LT((chord(c.foam, forward_side(c.film)) - Vec2(0.0, -0.0499)).norm(), kRounding);
}

TEST(ApplyT1Rule, LeavesAShortFilmThatWouldCloseAgain) {
    Crossing c = crossing(25.0, 0.0499);
    const Foam before = c.foam;
    EXPECT_FALSE(apply_t1_rule(c.foam, c.film, {}));
    EXPECT_TRUE(test::are_same(c.foam, before));
}

// A film shorter than 0.05 * 0.05 = 0.0025 has collapsed. It is opened to twice this length,
// flipped or not.
TEST(ApplyT1Rule, OpensACollapsedFilmEitherWay) {
    Crossing along = crossing(25.0, 0.0024);
    EXPECT_FALSE(apply_t1_rule(along.foam, along.film, {}));
    EXPECT_NEAR(chord(along.foam, forward_side(along.film)).norm(), 0.005, kRounding);
    Crossing across = crossing(60.0, 0.0024);
    EXPECT_TRUE(apply_t1_rule(across.foam, across.film, {}));
    EXPECT_NEAR(chord(across.foam, forward_side(across.film)).norm(), 0.005, kRounding);
}

// At 45 degrees the states before and after the flip are equivalent, and both stay open:
// 2 sin 45 = 1.4 > 1. Without t1_armed the film would flip to and fro.
TEST(Hysteresis, AFilmThatHasFlippedDoesNotFlipBack) {
    Crossing c = crossing(45.0, 0.04);
    ASSERT_TRUE(apply_t1_rule(c.foam, c.film, {}));
    ASSERT_TRUE(would_stay_open(c.foam, c.film));
    EXPECT_FALSE(apply_t1_rule(c.foam, c.film, {}));
    EXPECT_TRUE(short_films(c.foam, {}).empty());
    c.foam.t1_armed[c.film] = 1;
    EXPECT_TRUE(apply_t1_rule(c.foam, c.film, {}));
}

// The film is armed again at twice its T1 distance, which is 0.05 if a bubble of area 1/4 halves
// the distance.
TEST(Hysteresis, AFilmIsArmedAgainWhenItHasGrown) {
    for (const double target : {4.0, 0.25}) {
        const double distance = target < 1.0 ? 0.025 : 0.05;
        for (const double length : {1.98 * distance, 2.02 * distance}) {
            Crossing c = crossing(60.0, length);
            c.foam.target_areas[BubbleId{2}] = target;
            c.foam.t1_armed[c.film] = 0;
            rearm_grown_films(c.foam, {});
            EXPECT_EQ(c.foam.t1_armed[c.film], length > 2.0 * distance ? 1 : 0);
        }
    }
}

TEST(ApplyT1Rule, CountsTheChangesAtSeveralFilms) {
    Crossing flips = crossing(60.0, 0.04);
    Foam expected = flips.foam;
    ASSERT_TRUE(apply_t1_rule(expected, flips.film, {}));
    const Network& network = flips.foam.network;
    const std::vector<FilmId> all = network.films().ids(network.film_count());
    EXPECT_EQ(apply_t1_rule(flips.foam, all, {}), 1);
    EXPECT_TRUE(test::are_same(flips.foam, expected));
    Crossing stays = crossing(25.0, 0.04);
    EXPECT_EQ(apply_t1_rule(stays.foam, all, {}), 0);
}

TEST(ShortFilms, AreThoseThatStayOpenWhenFlipped) {
    EXPECT_EQ(short_films(crossing(60.0, 0.04).foam, {}),
              (std::vector<FilmId>{crossing(60.0, 0.04).film}));
    EXPECT_TRUE(short_films(crossing(25.0, 0.04).foam, {}).empty());
    EXPECT_TRUE(short_films(crossing(60.0, 0.06).foam, {}).empty());
}

TEST(ShortFilms, ComeInIncreasingOrder) {
    const Foam foam = honeycomb(4, 4);
    const std::vector<FilmId> films = short_films(foam, {.t1_distance = 1.0});
    ASSERT_EQ(films.size(), 48U);  // all are shorter than 1 and would stay open
    for (std::size_t k = 0; k < films.size(); ++k) {
        EXPECT_EQ(films[k], id_at<FilmId>(k));
    }
}

}  // namespace
}  // namespace foam
