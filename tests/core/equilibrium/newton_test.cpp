// SPDX-License-Identifier: Apache-2.0

#include "core/equilibrium/newton.h"

#include "core/equilibrium/relaxation.h"
#include "core/equilibrium/residual.h"
#include "core/foam/honeycomb.h"
#include "core/foam/measure.h"
#include "core/foam/random.h"
#include "tests/core/equilibrium/crossing.h"
#include "tests/core/foams.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace foam {
namespace {

using test::are_same;
using test::is_valid;

// Returns a honeycomb whose junctions are moved by up to `largest` in x and y.
Foam perturbed_honeycomb(double largest) {
    Foam foam = honeycomb(6, 6);
    Random random(3);
    for (Vec2& position : foam.positions) {
        const double x = largest * (2.0 * random.uniform() - 1.0);
        const double y = largest * (2.0 * random.uniform() - 1.0);
        position += Vec2(x, y);
    }
    return foam;
}

NewtonSummary run(Foam& foam, const NewtonOptions& options) {
    return newton(foam, all_unknowns(foam.network), options);
}

double residual_of(const Foam& foam) {
    const Unknowns unknowns = all_unknowns(foam.network);
    const ResidualNorms n = norms(foam, unknowns, residual(foam, unknowns));
    return std::max(n.force, n.area);
}

TEST(Newton, DoesNothingInAHoneycomb) {
    Foam foam = honeycomb(4, 4);
    const Foam before = foam;
    const NewtonSummary summary = run(foam, {});
    EXPECT_EQ(summary.status, NewtonStatus::Converged);
    EXPECT_EQ(summary.iterations, 0);
    EXPECT_TRUE(are_same(foam, before));
}

// Each residual is at most the square of the residual before it, down to rounding errors. The
// regularization of the Hessian has no visible effect.
TEST(Newton, ConvergesQuadratically) {
    constexpr double kRoundingFloor =
        1e-13;  // some hundred units in the last place of a film length
    Foam foam = perturbed_honeycomb(0.025);
    double before = residual_of(foam);
    ASSERT_GT(before, 0.02);
    for (int k = 0; k < 4; ++k) {
        const NewtonSummary summary =
            run(foam, {.max_iterations = 1, .force_tolerance = 0.0, .area_tolerance = 0.0});
        EXPECT_EQ(summary.status, NewtonStatus::IterationLimit);
        EXPECT_LT(summary.residual, before * before + kRoundingFloor);
        before = summary.residual;
    }
    EXPECT_LT(before, kRoundingFloor);
}

TEST(Newton, FindsTheHoneycombAgain) {
    Foam foam = perturbed_honeycomb(0.1);
    EXPECT_EQ(run(foam, {}).status, NewtonStatus::Converged);
    const EquilibriumErrors errors = equilibrium_errors(foam);
    EXPECT_LT(errors.area, 1e-10);
    EXPECT_LT(errors.angle, 1e-10);
    EXPECT_NEAR(energy(foam) / 36.0, std::sqrt(2.0 * std::sqrt(3.0)), 1e-12);
}

TEST(Newton, ReportsItsResidual) {
    Foam foam = perturbed_honeycomb(0.1);
    const NewtonSummary cut = run(foam, {.max_iterations = 2});
    EXPECT_EQ(cut.status, NewtonStatus::IterationLimit);
    EXPECT_EQ(cut.iterations, 2);
    EXPECT_NEAR(cut.residual, residual_of(foam), 1e-13);  // the junctions have been wrapped since
}

TEST(Newton, StopsWhenBothTolerancesAreMet) {
    for (const double tolerance : {1e-3, 1e-6}) {
        Foam foam = perturbed_honeycomb(0.05);
        const NewtonSummary summary =
            run(foam, {.force_tolerance = tolerance, .area_tolerance = tolerance});
        EXPECT_EQ(summary.status, NewtonStatus::Converged);
        EXPECT_LT(residual_of(foam), tolerance);
        EXPECT_GE(summary.iterations, 1);
    }
}

TEST(Newton, DoesNothingWithoutIterations) {
    Foam foam = perturbed_honeycomb(0.05);
    const NewtonSummary summary = run(foam, {.max_iterations = 0});
    EXPECT_EQ(summary.status, NewtonStatus::IterationLimit);
    EXPECT_EQ(summary.iterations, 0);
    EXPECT_DOUBLE_EQ(summary.residual, residual_of(foam));
}

TEST(Newton, LeavesAFilmThatHasCollapsedToTheT1) {
    test::Crossing c = test::crossing(25.0, 0.0024);
    const Foam before = c.foam;
    const NewtonSummary summary = run(c.foam, {});
    EXPECT_EQ(summary.status, NewtonStatus::FilmsNeedT1);
    EXPECT_EQ(summary.iterations, 0);
    EXPECT_EQ(summary.films_for_t1, (std::vector<FilmId>{c.film}));
    EXPECT_TRUE(are_same(c.foam, before));
}

// Without the step, a foam of a million bubbles would make no progress: in each step, some of its
// films need a T1.
TEST(Newton, MakesAStepOfALargeFoamAlthoughAFilmNeedsAT1) {
    for (const int columns : {6, 142}) {  // 108 and 60,492 films
        Foam foam = honeycomb(columns, columns);
        const FilmId film = id_at<FilmId>(foam.network.film_slots() / 2);
        foam.positions[foam.network.head(forward_side(film))] -=
            0.999 * chord(foam, forward_side(film));
        const double before = residual_of(foam);
        const NewtonSummary summary = run(foam, {});
        EXPECT_EQ(summary.status, NewtonStatus::FilmsNeedT1);
        EXPECT_EQ(summary.films_for_t1, (std::vector<FilmId>{film}));
        EXPECT_EQ(summary.iterations, columns == 6 ? 0 : 1);
        if (columns == 6) {
            EXPECT_EQ(residual_of(foam), before);
        } else {
            EXPECT_LT(residual_of(foam), before);
        }
    }
}

// Without T1s, Newton's method stalls far from equilibrium. A system that can raise its precision
// afterwards has not done so before.
TEST(Newton, RaisesThePrecisionFarFromEquilibriumOnlyIfAllowed) {
    for (const bool is_allowed : {true, false}) {
        Foam foam = test::raw_foam(200, 1);
        NewtonSystem system;
        system.start(foam, all_unknowns(foam.network), 1);
        const NewtonSummary summary = newton(foam,
                                             system,
                                             {.max_iterations = 1000,
                                              .raises_precision_far = is_allowed,
                                              .thresholds = {.t1_distance = 0.0}});
        EXPECT_EQ(summary.status, NewtonStatus::Stalled);
        EXPECT_GT(summary.residual, 0.1);
        EXPECT_EQ(system.raise_precision(foam), !is_allowed);
    }
}

// A raw diagram is far outside the region in which full steps of Newton's method converge. Every
// iteration must nevertheless decrease the sum of squares.
TEST(Newton, NeverRaisesTheSumOfSquares) {
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        Foam foam = test::raw_foam(60, seed);
        relax(foam, {.sweeps = 3});
        const Unknowns unknowns = all_unknowns(foam.network);
        double before = norms(foam, unknowns, residual(foam, unknowns)).squares;
        for (int k = 0; k < 10; ++k) {
            const NewtonSummary summary = newton(foam, unknowns, {.max_iterations = 1});
            const double now = norms(foam, unknowns, residual(foam, unknowns)).squares;
            EXPECT_TRUE(std::isfinite(now));
            EXPECT_LT(now, summary.iterations == 1 ? before : before * (1.0 + 1e-12));
            before = now;
        }
        EXPECT_TRUE(is_valid(foam.network));
    }
}

TEST(Newton, LeavesJunctionsInTheTorusOwnCell) {
    Foam foam = perturbed_honeycomb(0.2);
    run(foam, {});
    EXPECT_TRUE(is_valid(foam.network));
    for (const Vec2& position : foam.positions) {
        EXPECT_TRUE(foam.domain.cell_of(position) == (LatticeOffset{0, 0}));
    }
}

}  // namespace
}  // namespace foam
