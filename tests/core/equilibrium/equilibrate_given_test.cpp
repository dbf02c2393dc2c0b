// SPDX-License-Identifier: Apache-2.0

#include "core/equilibrium/equilibrate_given.h"

#include "core/foam/measure.h"
#include "core/foam/random.h"
#include "tests/core/foams.h"

#include <gtest/gtest.h>

#include <cmath>

namespace foam {
namespace {

// The foam in units in which its lengths and its tension are so many times larger.
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

// An equilibrium whose junctions have been moved by up to so much.
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

// With pressures that Newton's method cannot begin with, relaxation helps, without T1.
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

// A raw diagram has films that no equilibrium of its topology has.
TEST(EquilibrateGiven, MakesT1sAsALastResort) {
    Foam foam = test::raw_foam(200, 1);
    const EquilibriumSummary summary = equilibrate_given(foam, 1);
    EXPECT_TRUE(summary.converged());
    EXPECT_GT(summary.t1, 0);
    EXPECT_TRUE(test::is_valid(foam.network));
    EXPECT_LT(equilibrium_errors(foam).angle, 1e-9);
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

// A film that has flipped stays disarmed until it has grown, as between the steps of a foam.
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
        EXPECT_NEAR(foam.pressures[bubble], before.pressures[bubble], 1e-15);  // centered anew
    }
    foam.pressures = before.pressures;
    EXPECT_TRUE(test::are_same(foam, before));
}

TEST(EquilibrateGiven, KeepsAFoamWithoutEquilibrium) {
    Foam foam = test::equilibrated_foam(6, 1);
    // Targets that do not add up to the torus have no solution.
    foam.target_areas[BubbleId{0}] *= 3.0;
    const Foam before = foam;
    EXPECT_FALSE(equilibrate_given(foam, 1).converged());
    EXPECT_TRUE(test::are_same(foam, before));
}

}  // namespace
}  // namespace foam
