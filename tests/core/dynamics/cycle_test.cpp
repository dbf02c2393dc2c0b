// SPDX-License-Identifier: Apache-2.0

#include "core/dynamics/cycle.h"

#include "core/foam/honeycomb.h"
#include "core/foam/locate.h"
#include "core/foam/patch.h"
#include "tests/core/foams.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>

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
Foam after_cycles(Cycle cycle, Foam foam, int cycles) {
    for (int position = 0; position <= cycles * kSteps; ++position) {
        const StepSummary summary = cycle.step_to(position, foam, 0.0, {});
        EXPECT_TRUE(summary.equilibrium.converged()) << position;
    }
    return foam;
}

// Expects that one more cycle leads back to the same state after the given number of cycles.
void expect_closes(const Foam& start, const CycleOptions& options, int cycles) {
    Cycle cycle(start, options);
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

TEST(Cycle, LargeOscillationsCloseOnceTheirT1sAreDone) {
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
    Cycle cycle(start, {.steps = kSteps, .area_amplitude = 0.1});
    const Foam once = after_cycles(cycle, start, 1);
    EXPECT_LT(closing_error(once, after_cycles(cycle, once, 1)), kClosed);
    EXPECT_EQ(once.target_areas.size(), start.target_areas.size());
    EXPECT_NE(once.target_areas, start.target_areas);  // the phases are random
}

TEST(Cycle, NoGasDiffuses) {
    const Foam start = test::equilibrated_foam(60, 1);
    Cycle cycle(start, {.steps = kSteps, .area_amplitude = 0.0, .strain = 0.02});
    Foam foam = start;
    for (int position = 1; position <= kSteps; ++position) {
        cycle.step_to(position, foam, 1.0, {.coarsening = {.kappa = 1.0}});
    }
    EXPECT_LT(closing_error(start, foam), kClosed);
    EXPECT_EQ(foam.time, start.time + kSteps);
}

// Runs a boil, calming it after each cycle, until a cycle closes. Returns the number of cycles, or
// nothing if none of 60 cycles closes.
std::optional<int> cycles_until_closed(Cycle& cycle, Foam& foam) {
    EXPECT_TRUE(cycle.step_to(0, foam, 0.0, {}).equilibrium.converged());
    for (int count = 1; count <= 60; ++count) {
        const Foam start = foam;
        for (int position = 1; position <= kSteps; ++position) {
            EXPECT_TRUE(cycle.step_to(position, foam, 0.0, {}).equilibrium.converged());
        }
        if (closing_error(start, foam) < kClosed && cycle.repeats()) {
            return count;
        }
        cycle.calm(foam);
    }
    return std::nullopt;
}

// In each further cycle, every boiling bubble vanishes once and is born once.
void expect_boil_closes(Foam foam, int boiling) {
    const auto bubbles = static_cast<double>(foam.network.bubble_count());
    Cycle cycle(foam,
                {.steps = kSteps, .area_amplitude = 0.1, .boiling = boiling / bubbles, .seed = 3});
    ASSERT_TRUE(cycles_until_closed(cycle, foam));
    const Foam start = foam;
    foam.events.clear();
    for (int position = 1; position <= kSteps; ++position) {
        ASSERT_TRUE(cycle.step_to(position, foam, 0.0, {}).equilibrium.converged());
    }
    EXPECT_LT(closing_error(start, foam), kClosed);
    std::map<BubbleIdentity, int> births;
    std::map<BubbleIdentity, int> ends;
    for (const TopologyEvent& event : foam.events) {
        if (event.kind == TopologyEventKind::Birth) {
            ++births[event.bubbles.front()];
        } else if (event.kind == TopologyEventKind::T2) {
            ++ends[event.bubbles.front()];
        }
    }
    EXPECT_EQ(births.size(), boiling);
    EXPECT_EQ(births, ends);
    EXPECT_TRUE(std::ranges::all_of(births, [](const auto& entry) { return entry.second == 1; }));
}

TEST(Cycle, ABoilOfFewBubblesClosesByItself) {
    expect_boil_closes(test::equilibrated_foam(60, 1), 4);
}

TEST(Cycle, ABoilOfManyBubblesClosesWhenCalmed) {
    expect_boil_closes(test::equilibrated_foam(120, 1), 20);
}

TEST(Cycle, APatchBoils) {
    expect_boil_closes(equilibrated_patch(), 3);
}

// In the middle of its life, the boiling bubble is removed from its raft and becomes a lone bubble.
TEST(Cycle, ABoilingBubbleThatLeftItsRaftIsNotBornAgain) {
    Foam foam = equilibrated_patch();
    const CycleOptions options{.steps = kSteps, .boiling = 0.001};
    Cycle cycle(foam, options);
    Random random(options.seed);
    const BoilingBubble boiling =
        choose_boiling_bubbles(foam, options.boiling, options.boiling_rise, options.steps, random)
            .front();
    TopologyCounts counts;
    ASSERT_TRUE(collapse(foam, *find_bubble(foam, boiling.identity), counts));
    compact(foam);
    foam.lone_bubbles = {{boiling.identity, {20.0, 0.0}, 1.0}};
    const int middle = boiling.birth + kSteps / 2;
    ASSERT_TRUE(cycle.step_to(middle, foam, 0.0, {}).equilibrium.converged());
    EXPECT_FALSE(find_bubble(foam, boiling.identity));
    EXPECT_EQ(foam.lone_bubbles.size(), 1U);
}

TEST(Cycle, WithoutBoilingBubblesCalmingChangesNothing) {
    const Foam start = test::equilibrated_foam(60, 1);
    Cycle cycle(start, {.steps = kSteps, .area_amplitude = 0.35});
    Cycle calmed = cycle;
    Foam foam = start;
    Foam other = start;
    for (int position = 0; position <= kSteps; ++position) {
        cycle.step_to(position, foam, 0.0, {});
        calmed.step_to(position, other, 0.0, {});
        calmed.calm(other);
    }
    EXPECT_TRUE(test::are_same(foam, other));
    EXPECT_TRUE(cycle.repeats());
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

TEST(ClosingError, IsZeroIfAllBubblesAreLone) {
    Foam foam;
    foam.lone_bubbles = {{0, {0.0, 0.0}, 1.0}};
    EXPECT_EQ(closing_error(foam, foam), 0.0);
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
    Cycle cycle(start, {.steps = kSteps, .strain = 0.3});
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
