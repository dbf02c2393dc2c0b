// SPDX-License-Identifier: Apache-2.0

#include "core/equilibrium/equilibrate_given.h"

#include "core/foam/measure.h"
#include "core/foam/random.h"
#include "core/foam/t1_rule.h"
#include "tests/core/foams.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace foam {
namespace {

// Returns the foam in other units, in which lengths and film tension are multiplied by the given
// factors.
Foam scaled(Foam foam, double length, double tension) {
    foam.domain = {length * foam.domain.width, length * foam.domain.height};
    foam.film_tension *= tension;
    for (const JunctionId junction : foam.network.junctions()) {
        foam.positions[junction] *= length;
    }
    for (const BubbleId bubble : foam.network.bubbles()) {
        foam.target_areas[bubble] *= length * length;
        foam.pressures[bubble] *= tension / length;
    }
    return foam;
}

// Returns a foam in equilibrium whose junctions are then moved at random by up to `by` in
// x and in y.
Foam perturbed_foam(double by) {
    Foam foam = test::equilibrated_foam(60, 8);
    Random random(3);
    for (const JunctionId junction : foam.network.junctions()) {
        const Vec2 move(2.0 * random.uniform() - 1.0, 2.0 * random.uniform() - 1.0);
        place_junction(foam, junction, foam.positions[junction] + by * move);
    }
    return foam;
}

TEST(EquilibrateGiven, KeepsTheTopology) {
    Foam foam = perturbed_foam(0.05);
    const EquilibriumSummary summary = equilibrate_given(foam, 1);
    EXPECT_TRUE(summary.converged());
    EXPECT_EQ(summary.t1, 0);
    EXPECT_EQ(summary.sweeps, 0);
    EXPECT_LT(equilibrium_errors(foam).area, 1e-9);
    EXPECT_NEAR(energy(foam), energy(test::equilibrated_foam(60, 8)), 1e-9 * energy(foam));
}

// Newton's method fails from random pressures. Relaxation then leads to equilibrium, without T1.
TEST(EquilibrateGiven, RelaxesWithoutT1WhereNewtonFails) {
    Foam foam = perturbed_foam(0.05);
    Random random(4);
    for (double& pressure : foam.pressures) {
        pressure = 20.0 * random.uniform();
    }
    const EquilibriumSummary summary = equilibrate_given(foam, 1);
    EXPECT_TRUE(summary.converged());
    EXPECT_GT(summary.sweeps, 0);
    EXPECT_EQ(summary.t1, 0);
    EXPECT_NEAR(energy(foam), energy(test::equilibrated_foam(60, 8)), 1e-9 * energy(foam));
}

// A bubble of eight sides cannot become this small without T1s. At the start, T1s are due at one
// film at most.
TEST(EquilibrateGiven, MakesT1sAsALastResort) {
    Foam foam = test::equilibrated_foam(60, 8);
    BubbleId shrinking{0};
    BubbleId growing{0};
    for (const BubbleId bubble : foam.network.bubbles()) {
        const int sides = foam.network.sides(bubble);
        shrinking = sides > foam.network.sides(shrinking) ? bubble : shrinking;
        growing = sides < foam.network.sides(growing) ? bubble : growing;
    }
    ASSERT_GE(foam.network.sides(shrinking), 8);
    foam.target_areas[growing] += foam.target_areas[shrinking] - 0.02;
    foam.target_areas[shrinking] = 0.02;
    EXPECT_LE(short_films(foam, {}).size(), 1U);
    const EquilibriumSummary summary = equilibrate_given(foam, 1);
    EXPECT_TRUE(summary.converged());
    EXPECT_GT(summary.t1, 0);
    EXPECT_TRUE(test::is_valid(foam.network));
    EXPECT_LT(equilibrium_errors(foam).angle, 1e-9);
}

// There is no equilibrium with the topology of a raw diagram, so that no attempt is made to find
// one.
TEST(EquilibrateGiven, SolvesARawDiagramLikeASeededFoam) {
    Foam foam = test::raw_foam(200, 1);
    Foam seeded = foam;
    const EquilibriumSummary summary = equilibrate_given(foam, 1);
    EXPECT_TRUE(summary.converged());
    EXPECT_GT(summary.t1, 0);
    EXPECT_TRUE(test::is_valid(foam.network));
    EXPECT_LT(equilibrium_errors(foam).angle, 1e-9);
    const EquilibriumSummary expected = equilibrate(seeded, {});
    EXPECT_EQ(summary.iterations, expected.iterations);
    EXPECT_EQ(summary.sweeps, expected.sweeps);
    EXPECT_TRUE(test::are_same(foam, seeded));
}

// The positions of events are in the units of the foam: on its torus, which is 30 times larger.
TEST(EquilibrateGiven, AppendsTheEventsOfItsT1s) {
    Foam foam = scaled(test::raw_foam(200, 1), 30.0, 1.0);
    const TopologyEvent earlier{TopologyEventKind::Birth, 0.0, {1.0, 2.0}, {3}};
    foam.events.push_back(earlier);
    const EquilibriumSummary summary = equilibrate_given(foam, 1);
    ASSERT_GT(summary.t1, 0);
    ASSERT_EQ(foam.events.size(), 1U + static_cast<std::size_t>(summary.t1));
    EXPECT_EQ(foam.events[0], earlier);
    double farthest = 0.0;
    for (const TopologyEvent& event : foam.events) {
        farthest = std::max(farthest, event.position.norm());
    }
    EXPECT_GT(farthest, 0.5 * foam.domain.width);
}

TEST(EquilibrateGiven, KeepsAPatchOfLoneBubbles) {
    Foam foam;
    foam.network.add_ghost();
    complete_patch(foam);
    foam.lone_bubbles.push_back({0, {1.0, 2.0}, 3.0});
    const Foam before = foam;
    const EquilibriumSummary summary = equilibrate_given(foam, 1);
    EXPECT_TRUE(summary.converged());
    EXPECT_EQ(summary.energy, energy(before));
    EXPECT_EQ(foam.lone_bubbles, before.lone_bubbles);
}

TEST(EquilibrateGiven, UnitsDoNotMatter) {
    Foam foam = perturbed_foam(0.05);
    ASSERT_TRUE(equilibrate_given(foam, 1).converged());
    for (const double length : {1e-3, 0.3, 1e4}) {
        for (const double tension : {1e-3, 2.5, 1e5}) {
            Foam given = scaled(perturbed_foam(0.05), length, tension);
            const EquilibriumSummary summary = equilibrate_given(given, 1);
            ASSERT_TRUE(summary.converged());
            EXPECT_EQ(summary.energy, energy(given));
            const double unit = length * tension;
            EXPECT_NEAR(energy(given) / unit, energy(foam), 1e-10 * energy(foam));
            for (const BubbleId bubble : foam.network.bubbles()) {
                EXPECT_NEAR(
                    given.pressures[bubble] * length / tension, foam.pressures[bubble], 1e-9);
            }
        }
    }
}

TEST(EquilibrateGiven, KeepsGivenValuesBitForBit) {
    const Foam given = scaled(perturbed_foam(0.05), 0.37, 3.1);
    Foam foam = given;
    foam.time = 0.7;
    ASSERT_TRUE(equilibrate_given(foam, 1).converged());
    EXPECT_EQ(foam.time, 0.7);
    EXPECT_EQ(foam.film_tension, given.film_tension);
    EXPECT_EQ(foam.domain.width, given.domain.width);
    EXPECT_TRUE(foam.target_areas == given.target_areas);
    EXPECT_TRUE(foam.identities == given.identities);
    for (const Vec2& position : foam.positions) {
        EXPECT_TRUE(foam.domain.cell_of(position) == LatticeOffset{});
    }
}

// The shortest film is disarmed, as after a flip. It stays disarmed, because it has not grown.
TEST(EquilibrateGiven, KeepsAnEquilibrium) {
    Foam foam = test::equilibrated_foam(60, 8);
    FilmId shortest{};
    for (const FilmId film : foam.network.films()) {
        const auto length = [&](FilmId f) { return chord(foam, forward_side(f)).norm(); };
        shortest = length(film) < length(shortest) ? film : shortest;
    }
    foam.t1_armed[shortest] = 0;
    ASSERT_LT(chord(foam, forward_side(shortest)).norm(), 0.1);
    const Foam before = foam;
    ASSERT_TRUE(equilibrate_given(foam, 1).converged());
    for (const BubbleId bubble : foam.network.bubbles()) {
        EXPECT_NEAR(foam.pressures[bubble], before.pressures[bubble], 1e-15);  // centered again
    }
    foam.pressures = before.pressures;
    EXPECT_TRUE(test::are_same(foam, before));
}

TEST(EquilibrateGiven, KeepsAFoamWithoutEquilibrium) {
    Foam foam = test::equilibrated_foam(6, 1);
    // There is no equilibrium if the target areas do not add up to the area of the torus.
    foam.target_areas[BubbleId{0}] *= 3.0;
    const Foam before = foam;
    EXPECT_FALSE(equilibrate_given(foam, 1).converged());
    EXPECT_TRUE(test::are_same(foam, before));
}

}  // namespace
}  // namespace foam
