// SPDX-License-Identifier: Apache-2.0

#include "core/dynamics/step.h"
#include "core/foam/measure.h"
#include "tests/core/foams.h"

#include <gtest/gtest.h>

#include <numbers>

namespace foam {
namespace {

using test::equilibrated_foam;

// Growth rate of a bubble of n = 7 sides: (2 pi/3) gamma kappa (n - 6) for T = 1 and the default
// kappa of 0.01.
constexpr double kGrowthOfSeven = std::numbers::pi / 300.0;

// Expects that two foams have the same topology and agree in energy, chords and pressure
// differences.
void expect_same_foam(const Foam& a, const Foam& b, double tolerance) {
    ASSERT_EQ(a.network.film_count(), b.network.film_count());
    EXPECT_NEAR(energy(a), energy(b), tolerance);
    for (const FilmId film : a.network.films()) {
        const HalfEdgeId h = forward_side(film);
        ASSERT_EQ(a.network.left(h), b.network.left(h));
        ASSERT_EQ(a.network.next(h), b.network.next(h));
        EXPECT_LT((chord(a, h) - chord(b, h)).norm(), tolerance);
        EXPECT_NEAR(pressure_difference(a, h), pressure_difference(b, h), tolerance);
    }
}

// Expects that a solver follows Newton's method over several frames, in each of which the area of a
// bubble of seven sides changes by 1 % of the mean area. The tolerance of 5e-3 is larger than the
// errors of 1e-4, because these errors are multiplied in the pressures of small bubbles.
void expect_the_life_of_newton(int bubbles, int frames, Solver solver) {
    Foam by_newton = equilibrated_foam(bubbles, 1);
    Foam foam = by_newton;
    StepOptions options;
    options.solver = solver;
    options.equilibrium.tolerance = 1e-4;
    const double time = 0.01 / kGrowthOfSeven;
    for (int frame = 0; frame < frames; ++frame) {
        ASSERT_TRUE(step(by_newton, time, {}).equilibrium.converged());
        const StepSummary summary = step(foam, time, options);
        ASSERT_TRUE(summary.equilibrium.converged());
        EXPECT_LT(summary.equilibrium.area_error, 1e-4);
        EXPECT_LT(summary.equilibrium.angle_error, 1e-4);
        expect_same_foam(foam, by_newton, 5e-3);
    }
}

TEST(StepBySweeps, FollowsNewtonsMethod) {
    expect_the_life_of_newton(60, 4, Solver::GaussSeidel);
    expect_the_life_of_newton(60, 4, Solver::ColoredGaussSeidel);
}

TEST(LongStepBySweeps, FollowsNewtonsMethodOverManyFrames) {
    expect_the_life_of_newton(200, 5, Solver::GaussSeidel);
    expect_the_life_of_newton(200, 5, Solver::ColoredGaussSeidel);
}

}  // namespace
}  // namespace foam
