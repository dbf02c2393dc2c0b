// SPDX-License-Identifier: Apache-2.0

// Compares the paper's solver in a patch (paper 4.2, eq. 15) with Newton's method.
#include "core/equilibrium/equilibrate.h"
#include "core/equilibrium/newton.h"
#include "core/foam/measure.h"
#include "core/foam/patch.h"
#include "core/foam/random.h"
#include "core/reference/equilibrate_by_sweeps.h"
#include "core/reference/gauss_seidel.h"
#include "tests/core/foams.h"
#include "tests/core/patches.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace foam {
namespace {

class PatchGaussSeidelIn : public testing::TestWithParam<SweepOrder> {};

INSTANTIATE_TEST_SUITE_P(Orders,
                         PatchGaussSeidelIn,
                         testing::Values(SweepOrder::Sequential, SweepOrder::Colored));

Foam equilibrated(Foam foam) {
    EXPECT_TRUE(equilibrate(foam, {}).converged());
    return foam;
}

Foam equilibrated_disc(int bubbles) {
    PatchOptions options;
    options.bubbles = bubbles;
    options.lloyd_iterations = 3;
    return equilibrated(seed_patch(disc_outline(), options));
}

// Returns the foam with each target area changed at random by up to the given fraction.
Foam perturbed(Foam foam, double fraction) {
    Random random(5);
    for (const BubbleId bubble : foam.network.bubbles()) {
        foam.target_areas[bubble] *= 1.0 + fraction * (2.0 * random.uniform() - 1.0);
    }
    return foam;
}

// Expects that two foams agree in energy, pressures and films, up to a motion of each raft.
void expect_same_shape(const Foam& a, const Foam& b, double tolerance) {
    ASSERT_EQ(a.network.film_count(), b.network.film_count());
    EXPECT_NEAR(energy(a), energy(b), tolerance);
    for (const BubbleId bubble : a.network.bubbles()) {
        EXPECT_NEAR(a.pressures[bubble], b.pressures[bubble], tolerance);
    }
    for (const FilmId film : a.network.films()) {
        const FilmArc arc = film_arc(a, forward_side(film));
        const FilmArc other = film_arc(b, forward_side(film));
        EXPECT_NEAR(arc.chord.norm(), other.chord.norm(), tolerance);
        EXPECT_NEAR(arc.half_angle, other.half_angle, tolerance);
    }
}

void expect_the_solution_of_newton(const Foam& start, SweepOrder order) {
    Foam by_newton = start;
    const NewtonSummary newton_summary = newton(by_newton, all_unknowns(start.network), {});
    ASSERT_EQ(newton_summary.status, NewtonStatus::Converged);
    Foam foam = start;
    const GaussSeidelSummary summary = gauss_seidel(foam, {.tolerance = 1e-8, .order = order});
    EXPECT_EQ(summary.status, GaussSeidelStatus::Converged);
    EXPECT_GT(summary.sweeps, 1);
    EXPECT_EQ(summary.t1, 0);
    EXPECT_TRUE(equilibrium_errors(foam).are_below(1e-8));
    expect_same_shape(foam, by_newton, 1e-6);
}

double largest_half_angle(const Foam& foam) {
    double largest = 0.0;
    for (const FilmId film : foam.network.films()) {
        largest = std::max(largest, std::abs(film_arc(foam, forward_side(film)).half_angle));
    }
    return largest;
}

TEST_P(PatchGaussSeidelIn, FindsTheSolutionOfNewtonsMethod) {
    expect_the_solution_of_newton(perturbed(equilibrated(test::flower(1.0)), 0.05), GetParam());
    expect_the_solution_of_newton(perturbed(equilibrated_disc(37), 0.02), GetParam());
}

class LongPatchGaussSeidelIn : public PatchGaussSeidelIn {};

INSTANTIATE_TEST_SUITE_P(Orders,
                         LongPatchGaussSeidelIn,
                         testing::Values(SweepOrder::Sequential, SweepOrder::Colored));

TEST_P(LongPatchGaussSeidelIn, FindsTheSolutionOfNewtonsMethodForAHundredBubbles) {
    expect_the_solution_of_newton(perturbed(equilibrated_disc(100), 0.02), GetParam());
}

// The outer films of two nearly equal bubbles are arcs of about 240 degrees. The outer films of
// three are arcs of about 180 degrees. Laplace-Young's law alone does not determine such half
// angles.
TEST_P(PatchGaussSeidelIn, FindsHalfAnglesOfNinetyDegreesAndBeyond) {
    const Foam two = perturbed(equilibrated(test::double_bubble(1.0, 1.2)), 0.05);
    const Foam three = perturbed(equilibrated(test::triple_bubble(1.0)), 0.05);
    EXPECT_GT(largest_half_angle(two), 1.9);
    EXPECT_NEAR(largest_half_angle(three), 1.57, 0.01);
    expect_the_solution_of_newton(two, GetParam());
    expect_the_solution_of_newton(three, GetParam());
}

// A row can bend without a change of energy, so that only the energy and the pressures are
// determined.
TEST_P(PatchGaussSeidelIn, FindsTheEnergyOfARow) {
    Foam foam = perturbed(equilibrated(test::chain()), 0.05);
    EXPECT_GT(largest_half_angle(foam), 1.7);
    Foam by_newton = foam;
    ASSERT_EQ(newton(by_newton, all_unknowns(foam.network), {}).status, NewtonStatus::Converged);
    EXPECT_EQ(gauss_seidel(foam, {.tolerance = 1e-8, .order = GetParam()}).status,
              GaussSeidelStatus::Converged);
    EXPECT_NEAR(energy(foam), energy(by_newton), 1e-7);  // sum of p dA, with areas to 1e-8
    for (const BubbleId bubble : foam.network.bubbles()) {
        EXPECT_NEAR(foam.pressures[bubble], by_newton.pressures[bubble], 1e-6);
    }
}

// Tests the whole algorithm from the raw diagram on, including T1s at the surface.
TEST_P(PatchGaussSeidelIn, EquilibratesRawDiagrams) {
    int t1 = 0;
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        Foam foam = seed_patch(disc_outline(), {.bubbles = 40, .seed = seed});
        const EquilibriumSummary summary =
            equilibrate_by_sweeps(foam, GetParam(), {.tolerance = 1e-4});
        EXPECT_TRUE(summary.converged()) << "seed " << seed;
        EXPECT_TRUE(equilibrium_errors(foam).are_below(1e-4));
        EXPECT_TRUE(test::is_valid(foam.network));
        t1 += summary.t1;
    }
    EXPECT_GT(t1, 0);
}

}  // namespace
}  // namespace foam
