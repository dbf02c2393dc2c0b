// SPDX-License-Identifier: Apache-2.0

#include "core/equilibrium/equilibrate.h"

#include "core/equilibrium/newton_system.h"
#include "core/foam/honeycomb.h"
#include "core/foam/measure.h"
#include "core/foam/random.h"
#include "core/foam/seeding.h"
#include "tests/core/foams.h"
#include "tests/support/sample_foams.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <numeric>
#include <string>
#include <vector>

namespace foam {
namespace {

using test::are_same;
using test::equilibrated_foam;
using test::is_valid;

constexpr double kPi = std::numbers::pi;

std::string case_name(const SeedingOptions& s) {
    return std::to_string(s.bubbles) + " bubbles, seed " + std::to_string(s.seed) + ", ratio " +
           std::to_string(s.area_ratio) + ", aspect " + std::to_string(s.aspect);
}

// Scales the target areas so that they add up to the area of the torus.
void scale_targets(Foam& foam) {
    const double scale = foam.domain.area() / test::total_target(foam);
    for (double& area : foam.target_areas) {
        area *= scale;
    }
}

void expect_equilibrium(const SeedingOptions& seeding, const TopologyThresholds& thresholds = {}) {
    SCOPED_TRACE(case_name(seeding) + ", T1 distance " + std::to_string(thresholds.t1_distance));
    Foam foam = seed_foam(seeding);
    const EquilibriumSummary summary = equilibrate(foam, {.thresholds = thresholds});
    EXPECT_TRUE(summary.converged());
    EXPECT_TRUE(is_valid(foam.network));
    const EquilibriumErrors errors = equilibrium_errors(foam);
    EXPECT_LT(errors.area, 1e-9);
    EXPECT_LT(errors.angle, 1e-9);
    EXPECT_EQ(errors.films_at_limit, 0);
}

// The rounding errors of positions are as large as in a huge foam. One bubble is small, because
// they change the area of small bubbles most. With the tolerance of a small foam, Newton's method
// would stall, after 17 steps for the three seeds, and raise the precision of the factor in vain.
TEST(Equilibrate, AFoamWithLargeCoordinatesHasALargerTolerance) {
    int iterations = 0;
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        Foam foam = test::patch_foam(30, seed);
        foam.target_areas[BubbleId(1)] *= 0.02;
        ASSERT_TRUE(equilibrate(foam, {}).converged());
        for (const JunctionId junction : foam.network.junctions()) {
            foam.positions[junction] += Vec2(9000.0, -5000.0);
        }
        foam.target_areas[BubbleId(2)] *= 1.01;
        const EquilibriumSummary summary = equilibrate(foam, {.relaxes_first = false});
        EXPECT_TRUE(summary.converged()) << "seed " << seed;
        EXPECT_EQ(summary.relaxations, 0) << "seed " << seed;
        iterations += summary.iterations;
    }
    EXPECT_LT(iterations, 15);
}

// One bubble has 2e-9 of its area in the seeded foam. Because of rounding errors of positions, the
// errors there do not fall to the tolerance of Newton's method, but below that of the equilibrium.
TEST(Equilibrate, AFoamWithATinyBubbleIsNotRelaxed) {
    const EquilibriumOptions options{.thresholds = {.t1_distance = 1e-6}, .relaxes_first = false};
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        Foam foam = test::patch_foam(30, seed);
        for (int step = 0; step < 22; ++step) {
            foam.target_areas[BubbleId(1)] *= 0.4;
            ASSERT_TRUE(equilibrate(foam, options).converged());
        }
        for (const JunctionId junction : foam.network.junctions()) {
            foam.positions[junction] += Vec2(50.0, -50.0);
        }
        foam.target_areas[BubbleId(2)] *= 1.01;
        const EquilibriumSummary summary = equilibrate(foam, options);
        EXPECT_TRUE(summary.converged()) << "seed " << seed;
        EXPECT_EQ(summary.relaxations, 0) << "seed " << seed;
        EXPECT_GT(std::max(summary.area_error, summary.angle_error), 1e-11) << "seed " << seed;
    }
}

// Far from the origin, the tolerance of Newton's method does not exceed that of the equilibrium.
TEST(Equilibrate, AFoamFarFromTheOriginKeepsTheToleranceOfTheEquilibrium) {
    Foam foam = test::patch_foam(30, 1);
    for (const JunctionId junction : foam.network.junctions()) {
        foam.positions[junction] += Vec2(1e5, 1e5);
    }
    foam.target_areas[BubbleId(2)] *= 1.01;
    EXPECT_TRUE(equilibrate(foam, {.relaxes_first = false}).converged());
}

TEST(Equilibrate, EquilibratesRawDiagrams) {
    SeedingOptions seeding;
    seeding.bubbles = 100;
    for (seeding.seed = 1; seeding.seed <= 20; ++seeding.seed) {
        expect_equilibrium(seeding);
    }
}

TEST(LongEquilibrate, EquilibratesRawDiagramsOfAThousandBubbles) {
    SeedingOptions seeding;
    seeding.bubbles = 1000;
    for (seeding.seed = 1; seeding.seed <= 20; ++seeding.seed) {
        expect_equilibrium(seeding);
    }
}

TEST(Equilibrate, EquilibratesAreasSpreadByAHundred) {
    SeedingOptions seeding;
    seeding.area_ratio = 100.0;
    for (const int bubbles : {20, 100, 300}) {
        seeding.bubbles = bubbles;
        for (seeding.seed = 1; seeding.seed <= 10; ++seeding.seed) {
            expect_equilibrium(seeding);
        }
    }
}

// The target areas of nearly equal cells differ by a factor of up to 100. Films are at the limit of
// their half angle after all sweeps of one relaxation. Relaxations that restart each time would not
// lead to equilibrium.
TEST(Equilibrate, EquilibratesEqualCellsWithUnequalTargets) {
    Foam foam =
        seed_foam({.bubbles = 1000, .lloyd_iterations = 5, .area_ratio = 100.0, .seed = 19});
    EXPECT_TRUE(equilibrate(foam, {}).converged());
}

TEST(Equilibrate, EquilibratesEqualAreas) {
    SeedingOptions seeding;
    seeding.area_ratio = 1.0;
    seeding.bubbles = 100;
    for (seeding.seed = 1; seeding.seed <= 10; ++seeding.seed) {
        expect_equilibrium(seeding);
    }
}

TEST(Equilibrate, EquilibratesSlenderTori) {
    SeedingOptions seeding;
    seeding.bubbles = 100;
    for (const double aspect : {4.0, 0.25}) {
        seeding.aspect = aspect;
        for (seeding.seed = 1; seeding.seed <= 10; ++seeding.seed) {
            expect_equilibrium(seeding);
        }
    }
}

TEST(Equilibrate, EquilibratesAtAnyT1Distance) {
    SeedingOptions seeding;
    seeding.bubbles = 100;
    for (const double distance : {0.01, 0.25}) {
        for (seeding.seed = 1; seeding.seed <= 10; ++seeding.seed) {
            expect_equilibrium(seeding, {.t1_distance = distance});
        }
    }
}

// The tori are so small that bubbles are their own neighbors.
TEST(Equilibrate, EquilibratesTinyTori) {
    SeedingOptions seeding;
    for (seeding.bubbles = 2; seeding.bubbles <= 12; ++seeding.bubbles) {
        for (seeding.seed = 1; seeding.seed <= 20; ++seeding.seed) {
            expect_equilibrium(seeding);
        }
    }
}

// From the relaxed state of this foam, the residual grows along the limited step (limit_moves), but
// shrinks along the full step.
TEST(Equilibrate, EquilibratesWhereLimitedMovesStall) {
    SeedingOptions seeding;
    seeding.bubbles = 10;
    seeding.seed = 153;
    expect_equilibrium(seeding);
}

// With straight films a bubble of two sides has no area. Relaxation must reopen it.
TEST(Equilibrate, EquilibratesBubblesOfTwoSides) {
    for (const double area : {0.02, 0.2, 0.8}) {
        for (std::uint64_t seed = 1; seed <= 5; ++seed) {
            Foam foam = equilibrated_foam(30, seed);
            const BubbleId lens = test::insert_lens(foam, FilmId{7}, 0.5);
            foam.target_areas[lens] = area;
            scale_targets(foam);
            EXPECT_TRUE(equilibrate(foam, {}).converged()) << area << ", seed " << seed;
            EXPECT_TRUE(is_valid(foam.network));
            EXPECT_NEAR(bubble_area(foam, lens), foam.target_areas[lens], 1e-9);
        }
    }
}

TEST(Equilibrate, KeepsAHoneycomb) {
    Foam foam = honeycomb(4, 4);
    const EquilibriumSummary summary = equilibrate(foam, {.relaxes_first = false});
    EXPECT_TRUE(summary.converged());
    EXPECT_EQ(summary.sweeps, 0);
    EXPECT_EQ(summary.iterations, 0);
    EXPECT_EQ(summary.t1, 0);
    EXPECT_TRUE(are_same(foam, honeycomb(4, 4)));
}

TEST(Equilibrate, SummaryAgreesWithMeasuredErrors) {
    Foam foam = test::raw_foam(80, 4);
    const EquilibriumSummary summary = equilibrate(foam, {.relaxation_sweeps = 40});
    const EquilibriumErrors errors = equilibrium_errors(foam);
    EXPECT_EQ(summary.status, EquilibriumStatus::Converged);
    EXPECT_EQ(summary.area_error, errors.area);
    EXPECT_EQ(summary.angle_error, errors.angle);
    EXPECT_EQ(summary.energy, energy(foam));
    EXPECT_GE(summary.sweeps, 40);
    EXPECT_EQ(summary.sweeps % 40, 0);
    EXPECT_GT(summary.iterations, 0);
    EXPECT_GT(summary.t1, 0);
    EXPECT_EQ(summary.t2, 0);
}

TEST(Equilibrate, ReportsTheRoundLimit) {
    Foam foam = test::raw_foam(80, 4);
    const EquilibriumSummary summary = equilibrate(foam, {.max_rounds = 0});
    EXPECT_EQ(summary.status, EquilibriumStatus::RoundLimit);
    EXPECT_FALSE(summary.converged());
    EXPECT_GT(summary.angle_error, 1e-3);
    EXPECT_TRUE(is_valid(foam.network));
}

TEST(Equilibrate, ReportsAMissedTolerance) {
    Foam foam = test::raw_foam(80, 4);
    const EquilibriumSummary summary = equilibrate(foam, {.tolerance = 1e-30});
    EXPECT_EQ(summary.status, EquilibriumStatus::ToleranceMissed);
    EXPECT_LT(summary.angle_error, 1e-9);
}

TEST(Equilibrate, CentersThePressures) {
    const Foam foam = equilibrated_foam(50, 1);
    double weighted = 0.0;
    for (const BubbleId bubble : foam.network.bubbles()) {
        weighted += foam.target_areas[bubble] * foam.pressures[bubble];
    }
    EXPECT_NEAR(weighted, 0.0, 1e-12);
}

TEST(Equilibrate, ChangesAnEquilibriumOnlyByRounding) {
    Foam foam = equilibrated_foam(50, 1);
    const Foam before = foam;
    const EquilibriumSummary summary = equilibrate(foam, {.relaxes_first = false});
    EXPECT_TRUE(summary.converged());
    EXPECT_EQ(summary.t1, 0);
    for (const JunctionId junction : foam.network.junctions()) {
        EXPECT_LT((foam.positions[junction] - before.positions[junction]).norm(), 1e-9);
    }
}

TEST(Equilibrate, GivesTheSameBitsTwice) {
    EXPECT_TRUE(are_same(equilibrated_foam(200, 5), equilibrated_foam(200, 5)));
}

// A system that was used before changes only rounding errors, as long as it makes the same T1s. The
// target areas change by up to 2 % from call to call.
TEST(Equilibrate, AUsedSystemGivesTheSameEquilibrium) {
    EquilibriumOptions options{.relaxes_first = false};
    EquilibriumOptions used = options;
    used.system = std::make_shared<NewtonSystem>();
    Foam foam = equilibrated_foam(150, 7);
    Random random(4);
    int iterations = 0;
    for (int call = 0; call < 20; ++call) {
        for (double& area : foam.target_areas) {
            area *= 1.0 + 0.04 * (random.uniform() - 0.5);
        }
        scale_targets(foam);
        Foam other = foam;
        ASSERT_TRUE(equilibrate(foam, options).converged());
        const EquilibriumSummary summary = equilibrate(other, used);
        ASSERT_TRUE(summary.converged());
        iterations += summary.iterations;
        for (const JunctionId junction : foam.network.junctions()) {
            const Vec2 difference = foam.positions[junction] - other.positions[junction];
            ASSERT_LT(foam.domain.nearest_copy(difference).norm(), 1e-8) << call;
        }
    }
    EXPECT_GT(iterations, 20);
}

// The target areas determine all lengths, and pressures are proportional to the film tension.
TEST(Equilibrate, PressuresScaleWithTheTensionAndPositionsDoNot) {
    SeedingOptions seeding;
    seeding.bubbles = 60;
    for (seeding.seed = 1; seeding.seed <= 5; ++seeding.seed) {
        seeding.surface_tension = 0.5;
        Foam soft = seed_foam(seeding);
        seeding.surface_tension = 1.0;
        Foam stiff = seed_foam(seeding);
        const double soft_energy = equilibrate(soft, {}).energy;
        const double stiff_energy = equilibrate(stiff, {}).energy;
        EXPECT_NEAR(stiff_energy, 2.0 * soft_energy, 1e-9);
        for (const BubbleId bubble : soft.network.bubbles()) {
            EXPECT_NEAR(stiff.pressures[bubble], 2.0 * soft.pressures[bubble], 1e-9);
        }
        for (const JunctionId junction : soft.network.junctions()) {
            EXPECT_LT((stiff.positions[junction] - soft.positions[junction]).norm(), 1e-9);
        }
    }
}

// A honeycomb can have bubbles of different areas although all films are straight, all angles are
// 120 degrees and all pressures are equal (E2). The total film length is the same as in the regular
// honeycomb: 3a per bubble, with 3a = sqrt(2 sqrt(3)). Target areas that differ by up to a fifth
// therefore change neither the energy nor the topology.
TEST(Equilibrate, AHoneycombOfUnequalAreasHasStraightFilmsAndTheSameEnergy) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        Foam foam = honeycomb(6, 6);
        Random random(seed);
        for (double& area : foam.target_areas) {
            area = 0.9 + 0.2 * random.uniform();
        }
        scale_targets(foam);
        const EquilibriumSummary summary = equilibrate(foam, {});
        EXPECT_TRUE(summary.converged());
        EXPECT_EQ(summary.t1, 0);
        EXPECT_NEAR(summary.energy, 36.0 * std::sqrt(2.0 * std::sqrt(3.0)), 1e-10);
        for (const double pressure : foam.pressures) {
            EXPECT_NEAR(pressure, 0.0, 1e-10);
        }
    }
}

// Returns the curvature of the circle through three points, positive if they turn left.
double curvature_through(const Vec2& a, const Vec2& b, const Vec2& c) {
    return 2.0 * cross(b - a, c - a) / ((b - a).norm() * (c - b).norm() * (a - c).norm());
}

// Checks Laplace-Young's law (E1) by points on the films.
TEST(Equilibrate, FilmsAreCurvedByThePressureDifference) {
    Foam foam = equilibrated_foam(100, 6);
    foam.film_tension = 1.0;
    for (const FilmId film : foam.network.films()) {
        const HalfEdgeId h = forward_side(film);
        const FilmArc arc = film_arc(foam, h);
        const double seen =
            curvature_through(point_at(arc, 0.1), point_at(arc, 0.4), point_at(arc, 0.9));
        const double c = arc.chord.norm();
        // Rounding errors of 1e-16 in three points of a film of length c change the curvature by
        // about 1e-16/c².
        EXPECT_NEAR(seen, pressure_difference(foam, h) / foam.film_tension, 1e-14 / (c * c));
    }
}

// Returns the integral of x dy along the arc, by Simpson's rule on 64 intervals. Its error is the
// fourth power of the interval times the fourth derivative, and is below 1e-10 for half angles of
// up to 80 degrees.
double area_under(const FilmArc& arc, const Vec2& tail) {
    constexpr int kIntervals = 64;
    double sum = 0.0;
    for (int k = 0; k < kIntervals; ++k) {
        const Vec2 a = tail + point_at(arc, static_cast<double>(k) / kIntervals);
        const Vec2 middle = tail + point_at(arc, (k + 0.5) / kIntervals);
        const Vec2 b = tail + point_at(arc, (k + 1.0) / kIntervals);
        // Derivatives of the parabola through the three points.
        const Vec2 slope_a = 4.0 * middle - 3.0 * a - b;
        const Vec2 slope_middle = b - a;
        const Vec2 slope_b = 3.0 * b + a - 4.0 * middle;
        sum +=
            (a.x() * slope_a.y() + 4.0 * middle.x() * slope_middle.y() + b.x() * slope_b.y()) / 6.0;
    }
    return sum;
}

// Measures areas by Green's theorem from points on the films, without the formula for segments of
// E1.
TEST(Equilibrate, AreasAreTheirTargetsByQuadrature) {
    const Foam foam = equilibrated_foam(60, 6);
    for (const BubbleId bubble : foam.network.bubbles()) {
        Vec2 at = Vec2::Zero();
        double area = 0.0;
        for (const HalfEdgeId h : foam.network.around(bubble)) {
            area += area_under(film_arc(foam, h), at);
            at += chord(foam, h);
        }
        EXPECT_NEAR(area, foam.target_areas[bubble], 1e-8);
    }
}

// Around a bubble the tangent turns by 360 degrees: by 60 degrees at each of its n corners, and by
// the rest along its films. The diffusion through all films therefore adds up to von Neumann's law
// (E6).
TEST(Equilibrate, FilmsOfABubbleTurnBySixtyDegreesASideFewerThanSix) {
    const Foam foam = equilibrated_foam(200, 7);
    for (const BubbleId bubble : foam.network.bubbles()) {
        double turn = 0.0;
        for (const HalfEdgeId h : foam.network.around(bubble)) {
            const FilmArc arc = film_arc(foam, h);
            turn += curvature(arc) * arc_length(arc);
        }
        EXPECT_NEAR(turn, kPi / 3.0 * (6 - foam.network.sides(bubble)), 1e-8);
    }
}

// Pressures are the Lagrange multipliers of the areas (E3). The energies of neighboring equilibria
// therefore differ by the sum of p dA, the work done on the gas.
TEST(Equilibrate, EnergyGrowsByThePressureTimesTheArea) {
    const Foam foam = equilibrated_foam(30, 2);
    const double step = 1e-4;
    const BubbleId a{3};
    const BubbleId b{17};
    const auto energy_at = [&](double shift) {
        Foam other = foam;
        other.target_areas[a] += shift;
        other.target_areas[b] -= shift;
        const EquilibriumSummary summary = equilibrate(other, {.relaxes_first = false});
        EXPECT_TRUE(summary.converged());
        EXPECT_EQ(summary.t1, 0);
        return summary.energy;
    };
    const double slope = (energy_at(step) - energy_at(-step)) / (2.0 * step);
    // The error of the central difference is h² = 1e-8 times a third derivative of the order of 10.
    EXPECT_NEAR(slope, foam.pressures[a] - foam.pressures[b], 1e-6);
}

}  // namespace
}  // namespace foam
