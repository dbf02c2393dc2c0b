// SPDX-License-Identifier: Apache-2.0

#include "core/reference/gauss_seidel.h"

#include "core/equilibrium/newton.h"
#include "core/foam/honeycomb.h"
#include "core/foam/measure.h"
#include "core/foam/random.h"
#include "tests/core/equilibrium/crossing.h"
#include "tests/core/foams.h"
#include "tests/support/sample_foams.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace foam {
namespace {

using test::are_same;
using test::is_valid;

class GaussSeidelIn : public testing::TestWithParam<SweepOrder> {};

INSTANTIATE_TEST_SUITE_P(Orders,
                         GaussSeidelIn,
                         testing::Values(SweepOrder::Sequential, SweepOrder::Colored));

void expect_errors_below(const Foam& foam, double tolerance) {
    const EquilibriumErrors errors = equilibrium_errors(foam);
    EXPECT_LT(errors.area, tolerance);
    EXPECT_LT(errors.angle, tolerance);
    EXPECT_EQ(errors.films_at_limit, 0);
    EXPECT_TRUE(is_valid(foam.network));
}

// Returns a foam in equilibrium whose target areas are then changed by up to 5 %.
Foam perturbed_foam(int bubbles, std::uint64_t seed) {
    Foam foam = test::equilibrated_foam(bubbles, seed);
    Random random(seed);
    for (double& area : foam.target_areas) {
        area *= 0.95 + 0.1 * random.uniform();
    }
    const double scale = foam.domain.area() / test::total_target(foam);
    for (double& area : foam.target_areas) {
        area *= scale;
    }
    return foam;
}

void expect_same_shape(const Foam& a, const Foam& b, double tolerance) {
    EXPECT_NEAR(energy(a), energy(b), tolerance);
    for (const FilmId film : a.network.films()) {
        const HalfEdgeId h = forward_side(film);
        EXPECT_LT((chord(a, h) - chord(b, h)).norm(), tolerance);
        EXPECT_NEAR(pressure_difference(a, h), pressure_difference(b, h), tolerance);
    }
}

TEST_P(GaussSeidelIn, DoesNothingInAHoneycomb) {
    Foam foam = honeycomb(4, 4);
    const GaussSeidelSummary summary = gauss_seidel(foam, {.order = GetParam()});
    EXPECT_EQ(summary.status, GaussSeidelStatus::Converged);
    EXPECT_EQ(summary.sweeps, 0);
    EXPECT_EQ(summary.t1, 0);
    EXPECT_TRUE(are_same(foam, honeycomb(4, 4)));
}

// Both solvers solve the same equations (E2), so that their solutions agree up to a translation of
// the foam. The difference is about ten times the error that is left.
TEST_P(GaussSeidelIn, FindsTheSolutionOfNewtonsMethod) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        Foam foam = perturbed_foam(30, seed);
        Foam by_newton = foam;
        const NewtonSummary newton_summary = newton(by_newton, all_unknowns(foam.network), {});
        ASSERT_EQ(newton_summary.status, NewtonStatus::Converged);
        const GaussSeidelSummary summary =
            gauss_seidel(foam, {.tolerance = 1e-6, .order = GetParam()});
        EXPECT_EQ(summary.status, GaussSeidelStatus::Converged);
        EXPECT_GT(summary.sweeps, 10);
        EXPECT_EQ(summary.t1, 0);
        expect_errors_below(foam, 1e-6);
        expect_same_shape(foam, by_newton, 2e-5);
    }
}

// The paper also starts from raw diagrams (its Figure 4).
TEST_P(GaussSeidelIn, EquilibratesRawDiagrams) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        Foam foam = test::raw_foam(40, seed);
        const GaussSeidelSummary summary =
            gauss_seidel(foam, {.tolerance = 1e-3, .order = GetParam()});
        EXPECT_EQ(summary.status, GaussSeidelStatus::Converged) << "seed " << seed;
        expect_errors_below(foam, 1e-3);
    }
}

// The tori are so small that bubbles are their own neighbors.
TEST_P(GaussSeidelIn, EquilibratesTinyTori) {
    for (int bubbles = 2; bubbles <= 12; ++bubbles) {
        for (std::uint64_t seed = 1; seed <= 5; ++seed) {
            Foam foam = test::raw_foam(bubbles, seed);
            const GaussSeidelSummary summary = gauss_seidel(foam, {.order = GetParam()});
            EXPECT_EQ(summary.status, GaussSeidelStatus::Converged) << bubbles << ", " << seed;
            expect_errors_below(foam, 1e-4);
        }
    }
}

TEST_P(GaussSeidelIn, EquilibratesASingleBubble) {
    Foam foam = test::single_bubble();
    foam.positions[JunctionId{0}] += Vec2(0.05, -0.03);
    EXPECT_EQ(gauss_seidel(foam, {.order = GetParam()}).status, GaussSeidelStatus::Converged);
    expect_errors_below(foam, 1e-4);
}

TEST_P(GaussSeidelIn, FlipsAFilmThatHasCollapsed) {
    test::Crossing c = test::crossing(80.0, 0.0024);
    const BubbleId left = c.foam.network.left(forward_side(c.film));
    const BubbleId right = c.foam.network.right(forward_side(c.film));
    const GaussSeidelSummary summary = gauss_seidel(c.foam, {.order = GetParam()});
    EXPECT_EQ(summary.status, GaussSeidelStatus::Converged);
    EXPECT_GE(summary.t1, 1);
    EXPECT_NE(c.foam.network.left(forward_side(c.film)), left);
    EXPECT_NE(c.foam.network.right(forward_side(c.film)), right);
    expect_errors_below(c.foam, 1e-4);
}

// The angles at a film without length are undefined. Its junctions do not move until the T1 rule
// reopens the film.
TEST_P(GaussSeidelIn, OpensAFilmWithoutLength) {
    test::Crossing c = test::crossing(80.0, 0.0);
    ASSERT_EQ(chord(c.foam, forward_side(c.film)).norm(), 0.0);
    EXPECT_EQ(gauss_seidel(c.foam, {.order = GetParam()}).status, GaussSeidelStatus::Converged);
    expect_errors_below(c.foam, 1e-4);
}

TEST_P(GaussSeidelIn, StopsAtTheToleranceOrTheLimit) {
    const Foam start = perturbed_foam(30, 1);
    Foam foam = start;
    const GaussSeidelSummary loose = gauss_seidel(foam, {.tolerance = 1e-2, .order = GetParam()});
    expect_errors_below(foam, 1e-2);
    foam = start;
    const GaussSeidelSummary tight = gauss_seidel(foam, {.tolerance = 1e-4, .order = GetParam()});
    expect_errors_below(foam, 1e-4);
    EXPECT_LT(loose.sweeps, tight.sweeps);
    foam = start;
    const GaussSeidelSummary cut =
        gauss_seidel(foam, {.tolerance = 1e-4, .max_sweeps = 3, .order = GetParam()});
    EXPECT_EQ(cut.status, GaussSeidelStatus::SweepLimit);
    EXPECT_EQ(cut.sweeps, 3);
    EXPECT_TRUE(is_valid(foam.network));
}

// The change of a block is limited even far from equilibrium. In a sweep, a junction moves once,
// and a pressure changes once for each side of its bubble.
TEST_P(GaussSeidelIn, LimitsTheChangeOfABlock) {
    constexpr double kLargest = 1e-3;
    const Foam before = test::raw_foam(60, 2);
    Foam foam = before;
    gauss_seidel(foam, {.max_sweeps = 1, .order = GetParam(), .largest_change = kLargest});
    const double fraction = 1.01 * kLargest;  // lengths and units change during the sweep
    for (const FilmId film : before.network.films()) {
        const HalfEdgeId h = forward_side(film);
        const double length = chord(before, h).norm();
        EXPECT_LT((chord(foam, h) - chord(before, h)).norm(), 2.0 * fraction * length);
    }
    for (const BubbleId bubble : before.network.bubbles()) {
        const double unit = before.film_tension / std::sqrt(before.target_areas[bubble]);
        EXPECT_LT(std::abs(foam.pressures[bubble] - before.pressures[bubble]),
                  before.network.sides(bubble) * fraction * unit);
    }
}

// Areas differ from their targets by factors of up to a hundred, so that films reach the limit of
// their half angle and blocks become singular. The foam is not in equilibrium after these sweeps,
// but all its values are bounded.
TEST_P(GaussSeidelIn, StaysFiniteFarFromEquilibrium) {
    Foam foam = test::raw_foam(60, 1);
    for (const BubbleId bubble : foam.network.bubbles()) {
        foam.target_areas[bubble] = std::pow(100.0, static_cast<double>(index_of(bubble)) / 60.0);
    }
    const double scale = foam.domain.area() / test::total_target(foam);
    for (double& area : foam.target_areas) {
        area *= scale;
    }
    gauss_seidel(foam, {.max_sweeps = 60, .order = GetParam()});
    EXPECT_TRUE(is_valid(foam.network));
    EXPECT_LT(energy(foam), 10.0 * energy(test::raw_foam(60, 1)));
    for (const double pressure : foam.pressures) {
        EXPECT_LT(std::abs(pressure), 1e3);
    }
}

TEST_P(GaussSeidelIn, LeavesJunctionsInTheTorusOwnCell) {
    Foam foam = test::raw_foam(60, 1);
    gauss_seidel(foam, {.max_sweeps = 5, .order = GetParam()});
    EXPECT_TRUE(is_valid(foam.network));
    for (const Vec2& position : foam.positions) {
        EXPECT_TRUE(foam.domain.cell_of(position) == (LatticeOffset{0, 0}));
    }
}

// The sweeps from this raw diagram include T1s.
TEST(GaussSeidel, ColoredSweepsGiveTheSameBitsForAnyNumberOfThreads) {
    const auto run = [](int threads) {
        Foam foam = test::raw_foam(150, 3);
        const GaussSeidelSummary summary = gauss_seidel(
            foam, {.max_sweeps = 12, .order = SweepOrder::Colored, .threads = threads});
        EXPECT_GT(summary.t1, 0);
        return foam;
    };
    const Foam alone = run(1);
    for (const int threads : {2, 3, 0}) {
        EXPECT_TRUE(are_same(run(threads), alone)) << threads;
    }
}

TEST(GaussSeidel, OrdersReachTheSameSolution) {
    Foam sequential = perturbed_foam(30, 4);
    Foam colored = sequential;
    gauss_seidel(sequential, {.max_sweeps = 1});
    gauss_seidel(colored, {.max_sweeps = 1, .order = SweepOrder::Colored});
    EXPECT_FALSE(are_same(sequential, colored));
    gauss_seidel(sequential, {.tolerance = 1e-6});
    gauss_seidel(colored, {.tolerance = 1e-6, .order = SweepOrder::Colored});
    expect_same_shape(sequential, colored, 2e-5);
}

}  // namespace
}  // namespace foam
