// SPDX-License-Identifier: Apache-2.0

#include "core/foam/foam.h"

#include "core/foam/honeycomb.h"
#include "core/network/t2.h"
#include "tests/core/foams.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace foam {
namespace {

using test::are_same;
using test::is_valid;
using test::side_between;

constexpr double kRounding = 1e-14;  // rounding errors of coordinates up to about 10

constexpr double kSide = 0.62040323940139973;  // side of a hexagon of area 1: sqrt(2 / (3 sqrt(3)))

// The chords of all bubbles are those of a regular hexagon, also across the border of the torus'
// cell.
TEST(Foam, ChordsCrossTheSeam) {
    const Foam foam = honeycomb(2, 2);
    for (const BubbleId bubble : foam.network.bubbles()) {
        const std::vector<HalfEdgeId> loop = foam.network.around(bubble);
        for (std::size_t k = 0; k < 6; ++k) {
            // The first side is on the right and points up. Each further side turns left by 60
            // degrees.
            const double angle =
                std::numbers::pi / 2.0 + std::numbers::pi / 3.0 * static_cast<double>(k);
            const Vec2 expected = kSide * Vec2(std::cos(angle), std::sin(angle));
            EXPECT_LT((chord(foam, loop[k]) - expected).norm(), kRounding);
            EXPECT_LT((chord(foam, twin(loop[k])) + expected).norm(), kRounding);
        }
    }
}

TEST(Foam, PressureDifferenceIsLeftLessRight) {
    Foam foam = honeycomb(4, 4);
    foam.pressures[BubbleId{5}] = 3.0;
    foam.pressures[BubbleId{6}] = 1.0;
    const HalfEdgeId h = side_between(foam.network, BubbleId{5}, BubbleId{6});
    EXPECT_EQ(pressure_difference(foam, h), 2.0);
    EXPECT_EQ(pressure_difference(foam, twin(h)), -2.0);
}

// s = delta c / (2 T) = 1/2: the film bulges out of the bubble of higher pressure with a half angle
// of 30 degrees. Its curvature is the pressure difference divided by the tension (E1).
TEST(Foam, FilmsBulgeTowardsTheLowerPressure) {
    Foam foam = honeycomb(4, 4);
    foam.film_tension = 2.0;
    foam.pressures[BubbleId{5}] = foam.film_tension / kSide;
    const HalfEdgeId h = side_between(foam.network, BubbleId{5}, BubbleId{6});
    EXPECT_NEAR(film_arc(foam, h).half_angle, std::numbers::pi / 6.0, kRounding);
    EXPECT_NEAR(film_arc(foam, twin(h)).half_angle, -std::numbers::pi / 6.0, kRounding);
    EXPECT_NEAR(curvature(film_arc(foam, h)), 1.0 / kSide, kRounding);
    EXPECT_EQ(film_arc(foam, h).chord, chord(foam, h));
}

TEST(Foam, PlaceJunctionWrapsAndKeepsChords) {
    const Foam before = honeycomb(2, 2);
    const Vec2 shift(0.01, -0.02);
    for (const LatticeOffset periods : {LatticeOffset{0, 0}, LatticeOffset{3, -2}}) {
        Foam after = before;
        for (const JunctionId junction : before.network.junctions()) {
            // All junctions move by the same vector, so that in the end no chord has changed.
            place_junction(after,
                           junction,
                           before.positions[junction] + shift + before.domain.translation(periods));
        }
        EXPECT_TRUE(is_valid(after.network));
        for (const FilmId film : before.network.films()) {
            const HalfEdgeId h = forward_side(film);
            EXPECT_LT((chord(after, h) - chord(before, h)).norm(), kRounding);
        }
        for (const Vec2& position : after.positions) {
            EXPECT_TRUE(after.domain.cell_of(position) == (LatticeOffset{0, 0}));
        }
    }
}

TEST(Foam, CompactOfADenseFoamChangesNothing) {
    const Foam before = test::raw_foam(20, 1);
    Foam after = before;
    compact(after);
    EXPECT_TRUE(are_same(before, after));
}

// Bubble 5 vanishes. The ids of later bubbles become lower by one, and their values move with them.
TEST(Foam, CompactTakesAllValuesAlong) {
    Foam sparse = test::honeycomb_around(3);
    for (const BubbleId bubble : sparse.network.bubbles()) {
        const double k = static_cast<double>(index_of(bubble));
        sparse.pressures[bubble] = 0.1 * k;
        sparse.target_areas[bubble] = 1.0 + k;
    }
    vanish(sparse.network, BubbleId{5});
    Foam dense = sparse;
    compact(dense);
    ASSERT_TRUE(is_valid(dense.network));
    ASSERT_EQ(dense.pressures.size(), 15U);
    for (const BubbleId bubble : dense.network.bubbles()) {
        const BubbleId old = bubble < BubbleId{5} ? bubble : id_at<BubbleId>(index_of(bubble) + 1);
        EXPECT_EQ(dense.pressures[bubble], sparse.pressures[old]);
        EXPECT_EQ(dense.target_areas[bubble], sparse.target_areas[old]);
        EXPECT_EQ(dense.identities[bubble], sparse.identities[old]);
    }
    EXPECT_EQ(dense.next_identity, 16U);
}

TEST(Foam, CompactKeepsTheChordAndTheArmingOfEveryFilm) {
    Foam sparse = test::honeycomb_around(3);  // three of its films have flipped
    vanish(sparse.network, BubbleId{5});
    Foam dense = sparse;
    compact(dense);
    ASSERT_EQ(dense.positions.size(), 30U);
    ASSERT_EQ(dense.t1_armed.size(), 45U);
    auto film = dense.network.films().begin();
    for (const FilmId old : sparse.network.films()) {
        EXPECT_EQ(chord(dense, forward_side(*film)), chord(sparse, forward_side(old)));
        EXPECT_EQ(dense.t1_armed[*film], sparse.t1_armed[old]);
        ++film;
    }
}

}  // namespace
}  // namespace foam
