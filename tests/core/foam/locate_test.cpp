// SPDX-License-Identifier: Apache-2.0

#include "core/foam/locate.h"

#include "core/equilibrium/equilibrate.h"
#include "core/foam/honeycomb.h"
#include "tests/core/foams.h"
#include "tests/core/patches.h"
#include "tests/support/sample_foams.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace foam {
namespace {

using test::equilibrated_foam;

Vec2 middle_of(const Foam& foam, BubbleId bubble) {
    Vec2 at = foam.positions[foam.network.tail(foam.network.first(bubble))];
    Vec2 sum = Vec2::Zero();
    for (const HalfEdgeId h : foam.network.around(bubble)) {
        sum += at;
        at += chord(foam, h);
    }
    return sum / foam.network.sides(bubble);
}

TEST(Locate, FindsLiveBubblesByIdentity) {
    Foam foam = equilibrated_foam(20, 1);
    foam.identities[BubbleId{7}] = 99;
    EXPECT_EQ(find_bubble(foam, 99), BubbleId{7});
    EXPECT_EQ(find_bubble(foam, 7), std::nullopt);
    EXPECT_EQ(find_bubble(foam, 3), BubbleId{3});
}

TEST(Locate, ALoneBubbleIsPresent) {
    Foam foam = equilibrated_foam(20, 1);
    foam.lone_bubbles = {{99, {9.0, 0.0}, 1.0}};
    EXPECT_TRUE(is_present(foam, 3));
    EXPECT_TRUE(is_present(foam, 99));
    EXPECT_FALSE(is_present(foam, 20));
}

TEST(Locate, HoldsItsMiddleAndAllCopiesOfIt) {
    const Foam foam = equilibrated_foam(40, 2);
    for (const BubbleId bubble : foam.network.bubbles()) {
        for (const LatticeOffset copy : {LatticeOffset{0, 0}, {3, -2}, {-5, 4}}) {
            const Vec2 point = middle_of(foam, bubble) + foam.domain.translation(copy);
            EXPECT_EQ(winding_number(foam, bubble, point), 1);
            EXPECT_EQ(bubble_at(foam, point), bubble);
        }
    }
}

// Every point is in exactly one bubble, also on tori of a few large bubbles with strongly bent
// films.
TEST(Locate, BubblesCoverTheTorusOnce) {
    for (const int bubbles : {1, 2, 3, 12, 60}) {
        const Foam foam = bubbles == 1 ? test::single_bubble() : equilibrated_foam(bubbles, 3);
        for (int k = 0; k < 400; ++k) {
            const Vec2 point(0.013 + foam.domain.width * std::fmod(0.618 * k, 1.0),
                             foam.domain.height * (k + 0.5) / 400.0);
            int covered = 0;
            for (const BubbleId bubble : foam.network.bubbles()) {
                covered += winding_number(foam, bubble, point);
            }
            EXPECT_EQ(covered, 1) << bubbles << ' ' << point.transpose();
        }
    }
}

// A point between the arc and its chord belongs to the bubble of higher pressure.
TEST(Locate, FollowsTheArcsNotTheChords) {
    Foam foam = honeycomb(4, 4);
    const HalfEdgeId h = test::side_between(foam.network, BubbleId{5}, BubbleId{6});
    const Vec2 middle = foam.positions[foam.network.tail(h)] + 0.5 * chord(foam, h);
    const Vec2 outwards = -turned_left(chord(foam, h)).normalized();
    foam.pressures[BubbleId{5}] = 1.0;
    EXPECT_EQ(bubble_at(foam, middle + 0.03 * outwards), BubbleId{5});
    EXPECT_EQ(bubble_at(foam, middle + 0.2 * outwards), BubbleId{6});
    foam.pressures[BubbleId{5}] = -1.0;
    EXPECT_EQ(bubble_at(foam, middle - 0.03 * outwards), BubbleId{6});
    EXPECT_EQ(bubble_at(foam, middle - 0.2 * outwards), BubbleId{5});
}

TEST(Locate, FindsABubbleBesideAPointOnAFilm) {
    const Foam foam = equilibrated_foam(40, 2);
    for (const JunctionId junction : foam.network.junctions()) {
        const BubbleId found = bubble_at(foam, foam.positions[junction]).value();
        bool is_beside = false;
        for (const HalfEdgeId h : foam.network.leaving(junction)) {
            is_beside = is_beside || foam.network.left(h) == found;
        }
        EXPECT_TRUE(is_beside);
    }
}

TEST(Locate, ListsThoseOfANumberOfSidesSmallestFirst) {
    const Foam foam = equilibrated_foam(60, 1);
    std::size_t found = 0;
    for (int sides = 2; sides <= 12; ++sides) {
        double last = 0.0;
        for (const BubbleId bubble : bubbles_of_sides(foam, sides)) {
            EXPECT_EQ(foam.network.sides(bubble), sides);
            EXPECT_GE(foam.target_areas[bubble], last);
            last = foam.target_areas[bubble];
            ++found;
        }
    }
    EXPECT_EQ(found, 60U);
}

// Tests points near the junctions, and the middles of films, in another lattice copy of the torus.
TEST(Locate, FindsTheNearestJunctionAndFilm) {
    const Foam foam = equilibrated_foam(40, 2);
    const Vec2 far = foam.domain.translation({-2, 3});
    for (const JunctionId junction : foam.network.junctions()) {
        const Vec2 point = foam.positions[junction] + Vec2(0.01, -0.004);
        EXPECT_EQ(nearest_junction(foam, point + far), junction);
    }
    for (const FilmId film : foam.network.films()) {
        const HalfEdgeId h = forward_side(film);
        const Vec2 middle = foam.positions[foam.network.tail(h)] + 0.5 * chord(foam, h);
        EXPECT_EQ(nearest_film(foam, middle + far), film);
    }
}

// The films of a single bubble are about as long as the torus, so that the point is far from both
// ends.
TEST(Locate, FindsFilmsThatReachAroundTheTorus) {
    const Foam foam = test::single_bubble();
    for (const FilmId film : foam.network.films()) {
        const HalfEdgeId h = forward_side(film);
        const Vec2 tail = foam.positions[foam.network.tail(h)];
        EXPECT_EQ(nearest_film(foam, tail + 0.6 * chord(foam, h)), film);
    }
}

// Returns the distance from the point to the nearest of many lattice copies of the film's chord.
double distance_to_copies(const Foam& foam, FilmId film, const Vec2& point) {
    constexpr int kCopies = 4;
    const HalfEdgeId h = forward_side(film);
    const Vec2 along = chord(foam, h);
    double smallest = std::numeric_limits<double>::infinity();
    for (int i = -kCopies; i <= kCopies; ++i) {
        for (int j = -kCopies; j <= kCopies; ++j) {
            const Vec2 from = foam.positions[foam.network.tail(h)] - point +
                              foam.domain.translation(LatticeOffset{i, j});
            const double part = std::clamp(-from.dot(along) / along.squaredNorm(), 0.0, 1.0);
            smallest = std::min(smallest, (from + part * along).norm());
        }
    }
    return smallest;
}

// Where a torus has few bubbles, a film is as long as a period, so that the copy whose start is
// nearest to a point is often not the nearest copy.
TEST(Locate, FindsTheNearestFilmOfFewBubbles) {
    for (const int bubbles : {1, 2, 3, 5}) {
        const Foam foam = bubbles == 1 ? test::single_bubble() : equilibrated_foam(bubbles, 4);
        for (int k = 0; k < 100; ++k) {
            const Vec2 point(foam.domain.width * (k % 10 + 0.3) / 10.0,
                             foam.domain.height * (k / 10 + 0.7) / 10.0);
            double smallest = std::numeric_limits<double>::infinity();
            for (const FilmId film : foam.network.films()) {
                smallest = std::min(smallest, distance_to_copies(foam, film, point));
            }
            const FilmId found = nearest_film(foam, point);
            EXPECT_NEAR(distance_to_copies(foam, found, point), smallest, 1e-12)
                << bubbles << " bubbles, point " << k;
        }
    }
}

// The foam has three bubbles around a junction, and a lone bubble far away.
TEST(Locate, FindsNothingOutsideOfAPatch) {
    Foam foam = test::triple_bubble(1.0);
    ASSERT_TRUE(equilibrate(foam, {}).converged());
    foam.lone_bubbles.push_back({9, {5.0, 5.0}, 3.0});  // radius 0.98
    for (const BubbleId bubble : foam.network.bubbles()) {
        const Vec2 middle = middle_of(foam, bubble);
        EXPECT_EQ(bubble_at(foam, middle), bubble);
        EXPECT_EQ(identity_at(foam, middle), foam.identities[bubble]);
    }
    EXPECT_EQ(bubble_at(foam, {3.0, 0.0}), std::nullopt);
    EXPECT_EQ(bubble_at(foam, {5.0, 5.0}), std::nullopt);
    EXPECT_EQ(identity_at(foam, {3.0, 0.0}), std::nullopt);
    EXPECT_EQ(identity_at(foam, {5.7, 5.6}), 9U);
    EXPECT_EQ(identity_at(foam, {5.7, 5.8}), std::nullopt);
}

TEST(Locate, FindsTheNearestInThePlane) {
    const Foam foam = test::flower(1.0);
    for (const JunctionId junction : foam.network.junctions()) {
        const Vec2 beside = foam.positions[junction] + Vec2(0.01, -0.02);
        EXPECT_EQ(nearest_junction(foam, beside), junction);
    }
    for (const FilmId film : foam.network.films()) {
        const HalfEdgeId h = forward_side(film);
        const Vec2 middle = foam.positions[foam.network.tail(h)] + 0.5 * chord(foam, h);
        EXPECT_EQ(nearest_film(foam, middle), film);
    }
}

}  // namespace
}  // namespace foam
