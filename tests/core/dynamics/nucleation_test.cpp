// SPDX-License-Identifier: Apache-2.0

#include "core/dynamics/nucleation.h"

#include "core/dynamics/step.h"
#include "core/equilibrium/equilibrate.h"
#include "core/foam/honeycomb.h"
#include "core/foam/locate.h"
#include "core/foam/measure.h"
#include "tests/core/foams.h"
#include "tests/core/patches.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

namespace foam {
namespace {

using test::equilibrated_foam;
using test::is_valid;
using test::total_target;

constexpr double kPi = std::numbers::pi;
constexpr double kRoot3 = std::numbers::sqrt3;

// Returns options for a foam that is near equilibrium.
EquilibriumOptions from_near() {
    EquilibriumOptions options;
    options.relaxes_first = false;
    return options;
}

// Expects that a new bubble of area 0.02 in a honeycomb is in exact equilibrium and has the given
// pressure. `total` is the sum of the target areas before the nucleation.
void expect_exact(const Foam& foam, BubbleId bubble, double pressure, double total) {
    EXPECT_TRUE(is_valid(foam.network));
    EXPECT_NEAR(bubble_area(foam, bubble), 0.02, 1e-14);
    EXPECT_NEAR(foam.pressures[bubble], pressure, 1e-12);
    const EquilibriumErrors errors = equilibrium_errors(foam);
    EXPECT_LT(errors.angle, 1e-12);
    EXPECT_LT(errors.area, 1e-12);
    EXPECT_NEAR(total_target(foam), total, 1e-13);
}

// In a honeycomb, where films are straight and pressures equal, the new bubble is in exact
// equilibrium. It consists of arcs of radius c over chords of length c, with
//     c² (sqrt(3)/4 + 3 (pi/6 - sqrt(3)/4)) = 0.02.
// Its excess pressure is T / c. By symmetry, each neighbor loses exactly the area by which its
// target area decreases.
TEST(Nucleation, AtAJunctionOfAHoneycombIsExactAtOnce) {
    Foam foam = honeycomb(4, 4);
    const double total = total_target(foam);
    const BubbleId bubble = *nucleate_at_junction(foam, JunctionId{7}, 0.02);
    const double c = std::sqrt(0.02 / (kPi / 2.0 - kRoot3 / 2.0));
    expect_exact(foam, bubble, 1.0 / c, total);
}

// The new bubble consists of two segments of arcs with a half angle of 60 degrees and the radius R.
// The area of each segment is R² (pi/3 - sqrt(3)/4). The excess pressure is T / R.
TEST(Nucleation, OnAFilmOfAHoneycombIsExactAtOnce) {
    Foam foam = honeycomb(4, 4);
    const double total = total_target(foam);
    const BubbleId bubble = *nucleate_on_film(foam, FilmId{9}, 0.02);
    const double radius = std::sqrt(0.01 / (kPi / 3.0 - kRoot3 / 4.0));
    expect_exact(foam, bubble, 1.0 / radius, total);
}

TEST(Nucleation, TakesItsGasInProportion) {
    Foam foam = equilibrated_foam(40, 1);
    const Foam before = foam;
    const JunctionId junction{12};
    const BubbleId bubble = *nucleate_at_junction(foam, junction, 0.1);
    EXPECT_EQ(foam.target_areas[bubble], 0.1);
    double sum = 0.0;
    std::set<BubbleId> around;
    for (const HalfEdgeId h : before.network.leaving(junction)) {
        around.insert(before.network.left(h));
        sum += before.target_areas[before.network.left(h)];
    }
    for (const BubbleId old : before.network.bubbles()) {
        const double part = around.contains(old) ? 0.1 / sum : 0.0;
        EXPECT_NEAR(foam.target_areas[old], (1.0 - part) * before.target_areas[old], 1e-14);
    }
}

TEST(Nucleation, HasAnIdentityOfItsOwn) {
    Foam foam = equilibrated_foam(40, 1);
    const BubbleId first = *nucleate_at_junction(foam, JunctionId{3}, 0.02);
    const BubbleId second = *nucleate_on_film(foam, FilmId{50}, 0.02);
    EXPECT_EQ(foam.identities[first], 40U);
    EXPECT_EQ(foam.identities[second], 41U);
    EXPECT_EQ(foam.next_identity, 42U);
}

TEST(Nucleation, MayHaveTheIdentityOfABubbleThatHasVanished) {
    Foam foam = equilibrated_foam(40, 1);
    TopologyCounts counts;
    ASSERT_TRUE(collapse(foam, BubbleId{7}, counts));
    compact(foam);
    foam.events.clear();
    const BubbleId again = *nucleate_at_junction(foam, JunctionId{3}, 0.02, 7U);
    EXPECT_EQ(foam.identities[again], 7U);
    EXPECT_EQ(foam.events.front().bubbles.front(), 7U);
    EXPECT_EQ(foam.next_identity, 40U);
}

TEST(Nucleation, IsRejectedIfThereIsTooLittleGas) {
    Foam foam = honeycomb(4, 4);
    const Foam before = foam;
    EXPECT_FALSE(nucleate_at_junction(foam, JunctionId{3}, 1.51));
    EXPECT_FALSE(nucleate_on_film(foam, FilmId{3}, 1.01));
    EXPECT_TRUE(test::are_same(foam, before));
}

void expect_equilibrium(Foam& foam) {
    ASSERT_TRUE(is_valid(foam.network));
    ASSERT_TRUE(equilibrate(foam, from_near()).converged());
    const EquilibriumErrors errors = equilibrium_errors(foam);
    EXPECT_LT(errors.area, 1e-9);
    EXPECT_LT(errors.angle, 1e-9);
}

TEST(Nucleation, LeadsToAnEquilibriumAtEveryJunctionAndFilm) {
    const Foam equilibrated = equilibrated_foam(30, 3);
    for (const JunctionId junction : equilibrated.network.junctions()) {
        Foam foam = equilibrated;
        ASSERT_TRUE(nucleate_at_junction(foam, junction, 0.03)) << index_of(junction);
        ASSERT_NO_FATAL_FAILURE(expect_equilibrium(foam)) << "junction " << index_of(junction);
    }
    for (const FilmId film : equilibrated.network.films()) {
        Foam foam = equilibrated;
        ASSERT_TRUE(nucleate_on_film(foam, film, 0.03)) << index_of(film);
        ASSERT_NO_FATAL_FAILURE(expect_equilibrium(foam)) << "film " << index_of(film);
    }
}

// A new bubble to which gas is added pushes its neighbors aside and gains sides by T1s.
TEST(Nucleation, GrowsToAWholeBubble) {
    const Foam equilibrated = equilibrated_foam(30, 3);
    int gained = 0;
    for (std::size_t k = 0; k < 60; k += 4) {
        Foam foam = equilibrated;
        nucleate_at_junction(foam, id_at<JunctionId>(k), 0.02);
        const StepSummary summary = step(foam, 0.0, {{{30, 1.5, false}}}, {});
        ASSERT_TRUE(summary.equilibrium.converged()) << k;
        ASSERT_TRUE(is_valid(foam.network)) << k;
        const BubbleId bubble = *find_bubble(foam, 30);
        EXPECT_NEAR(bubble_area(foam, bubble), 1.5, 2e-9);
        gained += foam.network.sides(bubble) - 3;
    }
    EXPECT_GT(gained, 15);
}

// A T2 of the new bubble undoes the nucleation.
TEST(Nucleation, IsUndoneByT2) {
    const Foam equilibrated = equilibrated_foam(30, 3);
    for (const JunctionId junction : equilibrated.network.junctions()) {
        Foam foam = equilibrated;
        const BubbleId bubble = *nucleate_at_junction(foam, junction, 0.03);
        TopologyCounts counts;
        ASSERT_TRUE(collapse(foam, bubble, counts));
        EXPECT_EQ(counts.t1, 0);
        compact(foam);
        for (const FilmId film : equilibrated.network.films()) {
            const HalfEdgeId h = forward_side(film);
            EXPECT_EQ(foam.network.tail(h), equilibrated.network.tail(h));
            EXPECT_EQ(foam.network.head(h), equilibrated.network.head(h));
            EXPECT_LT((chord(foam, h) - chord(equilibrated, h)).norm(), 0.1);
        }
    }
}

// The parts of the films that are cut keep their arcs, so that only the new bubble is far from
// equilibrium.
TEST(Nucleation, AtTheSurfaceOfAPatchTakesItsGasFromTheAtmosphere) {
    for (const bool at_junction : {true, false}) {
        Foam foam = test::double_bubble(1.0, 2.0);
        ASSERT_TRUE(equilibrate(foam, {}).converged());
        const double total = total_target(foam);
        FilmId outer = *foam.network.films().begin();
        for (const FilmId film : foam.network.films()) {
            outer = foam.network.is_outer(film) ? film : outer;
        }
        const auto bubble = at_junction ? nucleate_at_junction(foam, JunctionId{0}, 0.02)
                                        : nucleate_on_film(foam, outer, 0.02);
        ASSERT_TRUE(bubble.has_value());
        EXPECT_TRUE(is_valid(foam.network));
        EXPECT_NEAR(total_target(foam), total + 0.02, 1e-15);
        EXPECT_LT(equilibrium_errors(foam).angle, 0.2);
        EXPECT_NEAR(bubble_area(foam, *bubble), 0.02, 0.002);
        ASSERT_TRUE(equilibrate(foam, from_near()).converged()) << at_junction;
        EXPECT_EQ(foam.network.bubble_count(), 3U);
    }
}

// Inside a patch, the gas comes from the surrounding bubbles, as on a torus.
TEST(Nucleation, WithinAPatchKeepsTheTotal) {
    Foam foam = test::flower(1.0);
    ASSERT_TRUE(equilibrate(foam, {}).converged());
    FilmId inner = *foam.network.films().begin();
    for (const FilmId film : foam.network.films()) {
        inner = foam.network.is_outer(film) ? inner : film;
    }
    ASSERT_TRUE(nucleate_on_film(foam, inner, 0.02).has_value());
    EXPECT_NEAR(total_target(foam), 7.0, 1e-14);
    ASSERT_TRUE(equilibrate(foam, from_near()).converged());
}

}  // namespace
}  // namespace foam
