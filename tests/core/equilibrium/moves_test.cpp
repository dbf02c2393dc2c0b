// SPDX-License-Identifier: Apache-2.0

#include "core/equilibrium/moves.h"

#include "core/foam/honeycomb.h"
#include "core/foam/random.h"
#include "tests/core/equilibrium/crossing.h"
#include "tests/core/foams.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

namespace foam {
namespace {

using test::Crossing;
using test::crossing;

TEST(AllowedFraction, LimitsHowMuchAFilmShrinks) {
    EXPECT_DOUBLE_EQ(allowed_fraction({2.0, 0.0}, {-0.7, 0.0}, 0.4), 1.0);
    EXPECT_DOUBLE_EQ(allowed_fraction({2.0, 0.0}, {-1.0, 0.0}, 0.4), 0.8);
    EXPECT_DOUBLE_EQ(allowed_fraction({2.0, 0.0}, {-8.0, 0.0}, 0.4), 0.1);
}

TEST(AllowedFraction, IsOneForAFilmThatGrows) {
    EXPECT_EQ(allowed_fraction({0.1, 0.0}, {50.0, 0.0}, 0.4), 1.0);
}

TEST(AllowedFraction, LimitsHowMuchAFilmTurns) {
    EXPECT_DOUBLE_EQ(allowed_fraction({0.0, 1.0}, {0.3, 0.0}, 0.4), 1.0);
    EXPECT_DOUBLE_EQ(allowed_fraction({0.0, 1.0}, {0.8, 0.0}, 0.4), 0.5);
    EXPECT_DOUBLE_EQ(allowed_fraction({0.0, 1.0}, {-0.8, 0.0}, 0.4), 0.5);
}

// If the change lengthens the film, the motion across the chord is limited in proportion to the new
// length: 0.4 (1 + 1) = 0.8 of a motion of 1.
TEST(AllowedFraction, LimitsATurnInProportionToTheNewLength) {
    EXPECT_DOUBLE_EQ(allowed_fraction({1.0, 0.0}, {1.0, 1.0}, 0.4), 0.8);
}

TEST(AllowedFraction, IsOneForAFilmWithoutLength) {
    EXPECT_EQ(allowed_fraction({0.0, 0.0}, {5.0, 1.0}, 0.4), 1.0);
}

double any_real() {
    return *rc::gen::inRange(-1000, 1001) * 1e-3;
}

Vec2 any_chord() {
    const Vec2 chord(any_real(), any_real());
    return chord.norm() < 1e-3 ? Vec2(1.0, 0.0) : chord;
}

RC_GTEST_PROP(AllowedFraction, KeepsTheLengthAboveItsLimit, ()) {
    const Vec2 chord = any_chord();
    const Vec2 change(4.0 * any_real(), 4.0 * any_real());
    const double fraction = allowed_fraction(chord, change, 0.4);
    RC_ASSERT(fraction > 0.0);
    RC_ASSERT(fraction <= 1.0);
    const double along = (chord + fraction * change).dot(chord) / chord.squaredNorm();
    RC_ASSERT(along >= 0.6 - 1e-12);
}

// Neither limit is exceeded. If the fraction is below 1, one of the limits is reached.
RC_GTEST_PROP(AllowedFraction, GoesJustAsFarAsTheLimits, ()) {
    const Vec2 chord = any_chord();
    const Vec2 change(4.0 * any_real(), 4.0 * any_real());
    const double fraction = allowed_fraction(chord, change, 0.4);
    const double c = chord.norm();
    const double along = change.dot(chord) / c;
    const double across = std::abs(cross(chord, change)) / c;
    const double margin_along = 0.4 * c + fraction * along;
    const double margin_across = 0.4 * (c + std::max(along, 0.0)) - fraction * across;
    RC_ASSERT(margin_along >= -1e-12);
    RC_ASSERT(margin_across >= -1e-12);
    RC_ASSERT(fraction == 1.0 || std::min(margin_along, margin_across) <= 1e-12);
}

TEST(State, ComesBackAtFractionZeroAndMovesInProportion) {
    Foam foam = test::raw_foam(20, 1);
    const Foam before = foam;
    const Unknowns unknowns = all_unknowns(foam.network);
    const Eigen::VectorXd step = Eigen::VectorXd::LinSpaced(unknowns.size(), -1.0, 1.0);
    const State state = state_of(foam, unknowns);
    set_state(foam, unknowns, state, step, 0.25);
    const JunctionId junction{7};
    const BubbleId bubble{11};
    const Vec2 moved =
        before.positions[junction] + 0.25 * step.segment<2>(unknowns.position_row(junction));
    EXPECT_EQ(foam.positions[junction], moved);
    EXPECT_EQ(foam.pressures[bubble],
              before.pressures[bubble] + 0.25 * step[unknowns.pressure_row(bubble)]);
    set_state(foam, unknowns, state, step, 0.0);
    EXPECT_TRUE(test::are_same(foam, before));
}

TEST(State, WrapsIntoTheTorusAndKeepsChords) {
    Foam foam = test::raw_foam(20, 1);
    const Foam before = foam;
    for (Vec2& position : foam.positions) {
        position += Vec2(7.5, -123.0);
    }
    wrap(foam, all_unknowns(foam.network));
    EXPECT_TRUE(test::is_valid(foam.network));
    for (const Vec2& position : foam.positions) {
        EXPECT_TRUE(foam.domain.cell_of(position) == (LatticeOffset{0, 0}));
    }
    for (const FilmId film : foam.network.films()) {
        const HalfEdgeId h = forward_side(film);
        EXPECT_LT((chord(foam, h) - chord(before, h)).norm(), 1e-12);
    }
}

TEST(LimitMoves, KeepsCommonMotion) {
    const Foam foam = test::raw_foam(30, 2);
    const Unknowns unknowns = all_unknowns(foam.network);
    Eigen::VectorXd step(unknowns.size());
    for (Eigen::Index row = 0; row < step.size(); ++row) {
        step[row] = row % 2 == 0 ? 8.0 : -64.0;
    }
    const Eigen::VectorXd before = step;
    limit_moves(foam, unknowns, 0.4, step);
    EXPECT_EQ(step, before);
}

// An end of a film of length a in a honeycomb is moved by 2a toward the other end, although the
// film may shorten by at most 0.4 a. Both ends share the correction equally, so that the sum of all
// moves does not change.
TEST(LimitMoves, SharesTheCutBetweenBothEnds) {
    const Foam foam = honeycomb(4, 4);
    const Unknowns unknowns = all_unknowns(foam.network);
    const HalfEdgeId h = foam.network.first(BubbleId{5});
    const Vec2 push = 2.0 * chord(foam, h);
    Eigen::VectorXd step = Eigen::VectorXd::Zero(unknowns.size());
    step.segment<2>(unknowns.position_row(foam.network.tail(h))) = push;
    limit_moves(foam, unknowns, 0.4, step);
    Vec2 sum = Vec2::Zero();
    for (const JunctionId junction : unknowns.junctions) {
        sum += step.segment<2>(unknowns.position_row(junction));
    }
    EXPECT_LT((sum - push).norm(), 1e-14);
    const Vec2 tail = step.segment<2>(unknowns.position_row(foam.network.tail(h)));
    EXPECT_LT(tail.norm(), 0.8 * push.norm());
}

TEST(LimitMoves, KeepsSmallStepsAndPressures) {
    const Foam foam = honeycomb(4, 4);
    const Unknowns unknowns = all_unknowns(foam.network);
    Eigen::VectorXd step = Eigen::VectorXd::Constant(unknowns.size(), 1e3);
    Random random(3);
    // No film, of length 0.62, changes by more than 0.14 in x or in y.
    for (Eigen::Index row = 0; row < static_cast<Eigen::Index>(2 * unknowns.junctions.size());
         ++row) {
        step[row] = 0.07 * (2.0 * random.uniform() - 1.0);
    }
    const Eigen::VectorXd before = step;
    limit_moves(foam, unknowns, 0.4, step);
    EXPECT_EQ(step, before);
}

// Some films still exceed their limit after the few sweeps of limit_moves, but no film is reversed.
TEST(LimitMoves, ReversesNoFilm) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        Foam foam = test::raw_foam(50, seed);
        const Unknowns unknowns = all_unknowns(foam.network);
        Eigen::VectorXd step(unknowns.size());
        Random random(seed);
        for (double& value : step) {
            value = 0.3 * (2.0 * random.uniform() - 1.0);
        }
        limit_moves(foam, unknowns, 0.4, step);
        const Foam before = foam;
        set_state(foam, unknowns, state_of(foam, unknowns), step, 1.0);
        for (const FilmId film : unknowns.films) {
            const HalfEdgeId h = forward_side(film);
            EXPECT_GT(chord(foam, h).dot(chord(before, h)), 0.0);
        }
    }
}

// Returns a step that shortens the film of a crossing by the given fraction of its length.
Eigen::VectorXd shortening(const Crossing& c, const Unknowns& unknowns, double part) {
    Eigen::VectorXd step = Eigen::VectorXd::Zero(unknowns.size());
    const HalfEdgeId h = forward_side(c.film);
    step.segment<2>(unknowns.position_row(c.foam.network.tail(h))) = part * chord(c.foam, h);
    return step;
}

// The T1 distance is 0.05 and the bubbles have area 1. A film of length 0.04 needs a T1 if the step
// shortens it by more than half and if it would stay open when flipped, as in a crossing of 60
// degrees.
TEST(CollapsingFilms, AreShortAndShrinkByMoreThanHalf) {
    const Crossing c = crossing(60.0, 0.04);
    const Unknowns unknowns = all_unknowns(c.foam.network);
    EXPECT_EQ(collapsing_films(c.foam, unknowns, shortening(c, unknowns, 0.51), {}),
              (std::vector<FilmId>{c.film}));
    EXPECT_TRUE(collapsing_films(c.foam, unknowns, shortening(c, unknowns, 0.49), {}).empty());
    EXPECT_TRUE(collapsing_films(c.foam, unknowns, shortening(c, unknowns, -2.0), {}).empty());
}

TEST(CollapsingFilms, AreNotLongerThanTheDistance) {
    const Crossing c = crossing(60.0, 0.051);
    const Unknowns unknowns = all_unknowns(c.foam.network);
    EXPECT_TRUE(collapsing_films(c.foam, unknowns, shortening(c, unknowns, 5.0), {}).empty());
}

// In a crossing of 25 degrees the flipped film would close again, because
// 2 sin(25 degrees) = 0.85 < 1.
TEST(CollapsingFilms, StayOpenWhenFlipped) {
    const Crossing c = crossing(25.0, 0.04);
    const Unknowns unknowns = all_unknowns(c.foam.network);
    EXPECT_TRUE(collapsing_films(c.foam, unknowns, shortening(c, unknowns, 0.9), {}).empty());
}

// A film below a twentieth of the T1 distance, 0.0025, has collapsed and needs a T1 for any step.
TEST(CollapsingFilms, IncludeTheCollapsed) {
    const Crossing c = crossing(25.0, 0.0024);
    const Unknowns unknowns = all_unknowns(c.foam.network);
    EXPECT_EQ(collapsing_films(c.foam, unknowns, shortening(c, unknowns, 0.0), {}),
              (std::vector<FilmId>{c.film}));
}

}  // namespace
}  // namespace foam
