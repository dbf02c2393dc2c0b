// SPDX-License-Identifier: Apache-2.0

#include "core/foam/rafts.h"

#include "core/equilibrium/equilibrate.h"
#include "core/foam/measure.h"
#include "core/foam/t1_rule.h"
#include "core/network/split.h"
#include "tests/core/foams.h"
#include "tests/core/patches.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace foam {
namespace {

FilmId film_between(const Foam& foam, std::size_t a, std::size_t b) {
    return film_of(test::side_between(foam.network, id_at<BubbleId>(a), id_at<BubbleId>(b)));
}

Foam equilibrated(Foam foam) {
    EXPECT_TRUE(equilibrate(foam, {}).converged());
    return foam;
}

// The chain tears into two rafts of two equal bubbles. The energy of each raft is known in closed
// form (film_arc_test.cpp).
TEST(Rafts, ATornChainIsTwoRaftsOfTwo) {
    Foam foam = equilibrated(test::chain());
    tear_film(foam, film_between(foam, 1, 2));
    EXPECT_TRUE(test::is_valid(foam.network));
    EquilibriumOptions options;
    options.relaxes_first = false;
    const EquilibriumSummary summary = equilibrate(foam, options);
    EXPECT_TRUE(summary.converged());
    EXPECT_NEAR(summary.energy, 2.0 * 6.359129253960, 1e-9);
}

// A bubble that comes loose becomes a circle of its area, which touches its old outer film. Its
// energy is 2 sqrt(pi A).
TEST(Rafts, ABubbleThatComesLooseIsACircle) {
    Foam foam = equilibrated(test::chain());
    const Vec2 before = point_at(
        film_arc(foam, test::side_between(foam.network, BubbleId{0}, foam.network.ghost())), 0.5);
    const HalfEdgeId outer = test::side_between(foam.network, BubbleId{0}, foam.network.ghost());
    const Vec2 far_end = foam.positions[foam.network.tail(outer)] + before;
    const BubbleIdentity identity = foam.identities[BubbleId{0}];
    tear_film(foam, film_between(foam, 0, 1));
    ASSERT_EQ(foam.lone_bubbles.size(), 1U);
    const LoneBubble& lone = foam.lone_bubbles.front();
    EXPECT_EQ(lone.identity, identity);
    EXPECT_EQ(lone.target_area, 1.0);
    EXPECT_NEAR((lone.center - far_end).norm(), lone_radius(lone), 0.2);
    EXPECT_TRUE(test::is_valid(foam.network));
    EXPECT_EQ(foam.network.bubble_count(), 3U);
    const double rest = energy(equilibrated(foam));
    Foam others = foam;
    others.lone_bubbles.clear();
    EXPECT_NEAR(rest - energy(equilibrated(others)), 2.0 * std::sqrt(std::numbers::pi), 1e-9);
}

TEST(Rafts, TheLastTwoComeLooseTogether) {
    Foam foam = equilibrated(test::double_bubble(1.0, 2.0));
    tear_film(foam, film_between(foam, 0, 1));
    EXPECT_EQ(foam.lone_bubbles.size(), 2U);
    EXPECT_LT(foam.lone_bubbles[0].identity, foam.lone_bubbles[1].identity);
    EXPECT_EQ(foam.network.film_count(), 0U);
    const EquilibriumSummary summary = equilibrate(foam, {});
    EXPECT_TRUE(summary.converged());
    EXPECT_NEAR(summary.energy, 2.0 * std::sqrt(std::numbers::pi) * (1.0 + std::sqrt(2.0)), 1e-12);
}

// A film between two bubbles of a row tears if it is shorter than the T1 distance. A longer film
// stays.
TEST(Rafts, AShortFilmBetweenTwoGhostsTears) {
    Foam foam = equilibrated(test::chain());
    const FilmId film = film_between(foam, 1, 2);
    EXPECT_FALSE(apply_t1_rule(foam, film, {}));
    EXPECT_TRUE(short_films(foam, {}).empty());
    const double length = chord(foam, forward_side(film)).norm();
    const TopologyThresholds thresholds{.t1_distance = 1.1 * length, .t2_area = 0.01};
    EXPECT_TRUE(apply_t1_rule(foam, film, thresholds));
    EXPECT_FALSE(foam.network.is_live(film));
    EXPECT_TRUE(test::is_valid(foam.network));
}

// A hole has the pressure of the ghost and therefore closes. Six bubbles around a junction would be
// too many: one of them moves to the middle, with five bubbles around it.
TEST(Rafts, AHoleCloses) {
    Foam foam = test::ring();
    const EquilibriumSummary summary = equilibrate(foam, {});
    EXPECT_TRUE(summary.converged());
    EXPECT_TRUE(test::is_valid(foam.network));
    EXPECT_EQ(foam.network.bubble_count(), 6U);
    EXPECT_GT(summary.t1, 0);
    EXPECT_EQ(foam.network.junction_count(), 10U);  // V - E + 7 = 2 (Euler), 2 E = 3 V
}

// Films that bulge far enough into a hole leave it no area. The hexagonal hole of side 0.6 has the
// area 0.94. A segment with a half angle of 2 has the area 0.09 (2 - sin 2 cos 2) / sin² 2 = 0.26
// (E1), so that six of them exceed the hole.
TEST(Rafts, BubblesOverlapInAHole) {
    Foam foam = test::ring();
    const auto bulge = [&](double angle) {
        for (const FilmId other : foam.network.films()) {
            if (foam.network.is_outer(other)) {
                const HalfEdgeId h = forward_side(other);
                const bool is_inward = foam.network.left(h) == foam.network.ghost();
                set_half_angle(foam, h, is_inward ? -angle : angle);
            }
        }
    };
    for (const double angle : {0.1, 2.0}) {
        bulge(angle);
        int holes = 0;
        for (const FilmId other : foam.network.films()) {
            holes += foam.network.is_outer(other) && is_overlapping_hole(foam, other) ? 1 : 0;
        }
        EXPECT_EQ(holes, angle < 1.0 ? 0 : 6);
    }
}

TEST(Rafts, ASmallHoleIsOneOfThreeShortFilms) {
    const Foam foam = equilibrated(test::triple_bubble(1.0));
    for (const FilmId film : foam.network.films()) {
        if (foam.network.is_outer(film)) {
            EXPECT_FALSE(is_small_hole(foam, film, 100.0));  // the boundary is around the raft
            EXPECT_FALSE(is_overlapping_hole(foam, film));
        }
    }
}

}  // namespace
}  // namespace foam
