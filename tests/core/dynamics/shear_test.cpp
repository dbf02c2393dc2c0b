// SPDX-License-Identifier: Apache-2.0

#include "core/dynamics/shear.h"

#include "core/dynamics/step.h"
#include "core/foam/honeycomb.h"
#include "core/foam/locate.h"
#include "core/foam/measure.h"
#include "core/io/evolver_file.h"
#include "core/io/foam_json.h"
#include "tests/core/foams.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace foam {
namespace {

using test::equilibrated_foam;
using test::is_valid;
using test::total_target;

StateChange strain_of(double strain) {
    StateChange change;
    change.strain = strain;
    return change;
}

// Shear maps every chord (x, y) to (x + strain y, y). This includes films that cross the border of
// the torus' cell, and strains for which the lattice is reduced. On this square torus the lattice
// is reduced if the magnitude of the strain is above 0.5.
TEST(Shear, IsAffine) {
    const Foam before = equilibrated_foam(40, 1);
    for (const double strain : {0.1, -0.3, 0.5, 0.7, -0.9, 3.2}) {
        Foam foam = before;
        shear(foam, strain);
        EXPECT_TRUE(is_valid(foam.network)) << strain;
        for (const FilmId film : foam.network.films()) {
            const Vec2 old = chord(before, forward_side(film));
            const Vec2 expected(old.x() + strain * old.y(), old.y());
            EXPECT_LT((chord(foam, forward_side(film)) - expected).norm(), 1e-12) << strain;
        }
        EXPECT_LE(std::abs(foam.domain.shear), 0.5 * foam.domain.width);
    }
}

// A strain of width / height maps the lattice of the torus to itself.
TEST(Shear, OfAWholePeriodGivesTheSameLattice) {
    Foam foam = honeycomb(4, 4);
    shear(foam, foam.domain.width / foam.domain.height);
    EXPECT_NEAR(foam.domain.shear, 0.0, 1e-14);
    EXPECT_TRUE(is_valid(foam.network));
    EXPECT_NEAR(bubble_area(foam, BubbleId{5}), 1.0, 1e-12);
}

// In the elastic range, without T1, a strain and its reversal lead back to the same pressures.
TEST(Shear, BackAndForthIsReversibleWithoutT1) {
    Foam foam = equilibrated_foam(60, 4);
    const Foam before = foam;
    for (const double strain : {0.001, 0.001, -0.001, -0.001}) {
        const StepSummary summary = step(foam, 0.0, strain_of(strain), {});
        ASSERT_TRUE(summary.equilibrium.converged());
        ASSERT_EQ(summary.equilibrium.t1, 0);
    }
    for (const BubbleId bubble : foam.network.bubbles()) {
        EXPECT_NEAR(foam.pressures[bubble], before.pressures[bubble], 1e-8);
    }
    EXPECT_NEAR(foam.domain.shear, 0.0, 1e-14);
}

// Princen's shear modulus of a honeycomb with films of length l is T / (2 sqrt(3) l) (J. Colloid
// Interface Sci. 91, 160, 1983). To the second order, the energy per area grows by half the modulus
// times the square of the strain.
TEST(Shear, EnergyOfAHoneycombGrowsByItsModulus) {
    const Foam before = honeycomb(4, 4);
    const double film = std::sqrt(2.0 / (3.0 * std::sqrt(3.0)));  // length, for bubbles of area 1
    const double modulus = before.film_tension / (2.0 * std::sqrt(3.0) * film);
    for (const double strain : {0.01, 0.02}) {
        Foam foam = before;
        ASSERT_TRUE(step(foam, 0.0, strain_of(strain), {}).equilibrium.converged());
        const double expected = 0.5 * modulus * strain * strain * foam.domain.area();
        EXPECT_NEAR((energy(foam) - energy(before)) / expected, 1.0, 2.0 * strain * strain);
    }
}

// The foam is sheared by several periods of the torus, far beyond the elastic range. T1s go on, and
// every step ends in equilibrium.
TEST(Shear, FlowsThroughSeveralPeriods) {
    Foam foam = equilibrated_foam(60, 2);
    int flips = 0;
    for (int k = 0; k < 100; ++k) {
        const StepSummary summary = step(foam, 0.0, strain_of(0.03), {});
        ASSERT_TRUE(summary.equilibrium.converged()) << k;
        ASSERT_TRUE(is_valid(foam.network)) << k;
        EXPECT_LT(summary.equilibrium.area_error, 1e-9);
        EXPECT_LT(summary.equilibrium.angle_error, 1e-9);
        flips += summary.equilibrium.t1;
    }
    EXPECT_GT(flips, 60);
    EXPECT_NEAR(total_target(foam), foam.domain.area(), 1e-9);
    EXPECT_EQ(foam.network.bubble_count(), 60U);
}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

// Returns the median, along x and along y separately, of the motions of all junctions relative to
// the shear.
Vec2 median_motion(const Foam& before, const Foam& after, double strain) {
    std::vector<double> along_x;
    std::vector<double> along_y;
    for (const JunctionId junction : before.network.junctions()) {
        const Vec2 old = before.positions[junction];
        const Vec2 expected(old.x() + strain * old.y(), old.y());
        const Vec2 motion = after.domain.nearest_copy(after.positions[junction] - expected);
        along_x.push_back(motion.x());
        along_y.push_back(motion.y());
    }
    return {median(along_x), median(along_y)};
}

// Equilibrium does not determine the position of the foam as a whole, so that an ill-conditioned
// step of Newton's method may translate all of it.
TEST(Shear, TheFoamAsAWholeStaysWhereItIs) {
    Foam foam = equilibrated_foam(200, 3);
    const double strain = 0.02;
    for (int k = 0; k < 50; ++k) {
        const Foam before = foam;
        ASSERT_TRUE(step(foam, 0.0, strain_of(strain), {}).equilibrium.converged()) << k;
        EXPECT_LT(median_motion(before, foam, strain).norm(), 1e-12) << k;
    }
}

TEST(Shear, ASummaryHasTheStrainOfAllSubsteps) {
    Foam foam = equilibrated_foam(60, 2);
    const StepSummary summary = step(foam, 1.0, strain_of(-1.4), {});
    ASSERT_TRUE(summary.equilibrium.converged());
    EXPECT_GT(summary.substeps, 1);
    EXPECT_NEAR(summary.strain, -1.4, 1e-14);
    EXPECT_EQ(step(foam, 1.0, {}).strain, 0.0);
}

TEST(Shear, ASteppedFoamCoarsensAsWell) {
    Foam foam = equilibrated_foam(60, 2);
    ASSERT_TRUE(step(foam, 0.0, strain_of(0.4), {}).equilibrium.converged());
    for (int k = 0; k < 20; ++k) {
        ASSERT_TRUE(step(foam, 3.0, {}).equilibrium.converged()) << k;
        ASSERT_TRUE(is_valid(foam.network));
    }
    EXPECT_LT(foam.network.bubble_count(), 55U);
}

TEST(Shear, PointsAreFoundInAShearedFoam) {
    Foam foam = equilibrated_foam(30, 3);
    ASSERT_TRUE(step(foam, 0.0, strain_of(0.37), {}).equilibrium.converged());
    for (int k = 0; k < 300; ++k) {
        const Vec2 point(0.013 + foam.domain.width * std::fmod(0.618 * k, 1.0),
                         foam.domain.height * (k + 0.5) / 300.0);
        int covered = 0;
        for (const BubbleId bubble : foam.network.bubbles()) {
            covered += winding_number(foam, bubble, point);
        }
        EXPECT_EQ(covered, 1) << point.transpose();
        EXPECT_EQ(bubble_at(foam, point),
                  bubble_at(foam, point + foam.domain.translation({2, -3})));
    }
    for (const JunctionId junction : foam.network.junctions()) {
        const Vec2 copy = foam.positions[junction] + foam.domain.translation({1, 2});
        EXPECT_EQ(nearest_junction(foam, copy), junction);
    }
}

TEST(Shear, AStateKeepsIt) {
    Foam foam = equilibrated_foam(30, 3);
    ASSERT_TRUE(step(foam, 0.0, strain_of(0.37), {}).equilibrium.converged());
    EXPECT_TRUE(test::are_same(read_foam_json(write_foam_json(foam), "a.json"), foam));
}

TEST(Shear, ADataFileKeepsIt) {
    Foam foam = equilibrated_foam(30, 3);
    ASSERT_TRUE(step(foam, 0.0, strain_of(0.37), {}).equilibrium.converged());
    const Foam back = read_evolver(write_evolver(foam, EvolverEdges::Arcs), "a.fe").foam;
    EXPECT_EQ(back.domain.shear, foam.domain.shear);
    EXPECT_NEAR(energy(back), energy(foam), 1e-9);
    EXPECT_LT(equilibrium_errors(back).angle, 1e-9);
    EXPECT_LT(equilibrium_errors(back).area, 1e-9);
}

}  // namespace
}  // namespace foam
