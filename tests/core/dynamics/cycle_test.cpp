// SPDX-License-Identifier: Apache-2.0

#include "core/dynamics/cycle.h"

#include "core/foam/honeycomb.h"
#include "core/foam/patch.h"
#include "tests/core/foams.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace foam {
namespace {

constexpr double kClosed = 1e-9;  // largest closing_error of a closed cycle, mean diameters
constexpr int kSteps = 24;

Foam equilibrated_patch() {
    Foam patch = seed_patch(disc_outline(), {.bubbles = 40, .seed = 1});
    EXPECT_TRUE(equilibrate(patch, {}).converged());
    return patch;
}

// Returns the foam at the start of a cycle, after the given number of cycles.
Foam after_cycles(const Cycle& cycle, Foam foam, int cycles) {
    for (int position = 0; position <= cycles * kSteps; ++position) {
        const StepSummary summary = cycle.step_to(position, foam, 0.0, {});
        EXPECT_TRUE(summary.equilibrium.converged()) << position;
    }
    return foam;
}

// Expects that one more cycle leads back to the same state after the given number of cycles.
void expect_closes(const Foam& start, const CycleOptions& options, int cycles) {
    const Cycle cycle(start, options);
    const Foam before = after_cycles(cycle, start, cycles);
    Foam foam = before;
    double largest = 0.0;
    for (int position = 1; position <= kSteps; ++position) {
        ASSERT_TRUE(cycle.step_to(position, foam, 0.0, {}).equilibrium.converged());
        largest = std::max(largest, closing_error(before, foam));
    }
    EXPECT_LT(closing_error(before, foam), kClosed);
    EXPECT_GT(largest, 1e-3);  // the foam has moved during the cycle
}

TEST(Cycle, OscillatingAreasCloseFromTheFirstOn) {
    expect_closes(test::equilibrated_foam(60, 1), {.steps = kSteps, .area_amplitude = 0.1}, 0);
}

TEST(Cycle, LargeOscillationsCloseOnceTheirT1AreThrough) {
    expect_closes(test::equilibrated_foam(60, 1), {.steps = kSteps, .area_amplitude = 0.35}, 3);
}

TEST(Cycle, ShearCloses) {
    expect_closes(test::equilibrated_foam(60, 1), {.steps = kSteps, .strain = 0.05}, 1);
}

TEST(Cycle, PatchCloses) {
    expect_closes(equilibrated_patch(), {.steps = kSteps, .area_amplitude = 0.1}, 1);
}

TEST(Cycle, ConvergesAfterOneCycle) {
    const Foam start = test::equilibrated_foam(60, 1);
    const Cycle cycle(start, {.steps = kSteps, .area_amplitude = 0.1});
    const Foam once = after_cycles(cycle, start, 1);
    EXPECT_LT(closing_error(once, after_cycles(cycle, once, 1)), kClosed);
    EXPECT_EQ(once.target_areas.size(), start.target_areas.size());
    EXPECT_NE(once.target_areas, start.target_areas);  // the phases are random
}

TEST(Cycle, NoGasDiffuses) {
    const Foam start = test::equilibrated_foam(60, 1);
    const Cycle cycle(start, {.steps = kSteps, .area_amplitude = 0.0, .strain = 0.02});
    Foam foam = start;
    for (int position = 1; position <= kSteps; ++position) {
        cycle.step_to(position, foam, 1.0, {.coarsening = {.kappa = 1.0}});
    }
    EXPECT_LT(closing_error(start, foam), kClosed);
    EXPECT_EQ(foam.time, start.time + kSteps);
}

// A honeycomb is translated by (0.03, -0.04), so that every junction moves by 0.05. The mean
// diameter is sqrt(4 / pi).
TEST(ClosingError, IsTheLargestDistanceOfACorner) {
    const Foam one = honeycomb(4, 4);
    Foam other = one;
    const Vec2 by(0.03, -0.04);
    for (const JunctionId junction : other.network.junctions()) {
        place_junction(other, junction, other.positions[junction] + by);
    }
    EXPECT_NEAR(closing_error(one, other), 0.05 / std::sqrt(4.0 * std::numbers::inv_pi), 1e-12);
    EXPECT_EQ(closing_error(one, one), 0.0);
}

TEST(ClosingError, IsInfiniteIfBubblesDiffer) {
    const Foam one = honeycomb(4, 4);
    Foam other = one;
    other.identities[BubbleId{3}] = 99;
    EXPECT_EQ(closing_error(one, other), std::numeric_limits<double>::infinity());
}

// The shear of a tall torus exceeds half its width, so that the same torus is described by a shear
// that is smaller by a whole width. A step to the present position must not shear it by that width.
TEST(Cycle, ATallTorusIsNotShearedByAWholeWidth) {
    const Foam start = honeycomb(4, 12);
    const Cycle cycle(start, {.steps = kSteps, .strain = 0.3});
    Foam foam = start;
    for (int position = 1; position <= kSteps / 4; ++position) {
        ASSERT_TRUE(cycle.step_to(position, foam, 0.0, {}).equilibrium.converged()) << position;
    }
    ASSERT_LT(foam.domain.shear, 0.0);  // 0.3 times the height, less the width
    const Foam before = foam;
    const StepSummary again = cycle.step_to(kSteps / 4, foam, 0.0, {});
    ASSERT_TRUE(again.equilibrium.converged());
    EXPECT_EQ(again.equilibrium.t1, 0);
    EXPECT_LT(closing_error(before, foam), kClosed);
}

}  // namespace
}  // namespace foam
