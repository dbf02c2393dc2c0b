// SPDX-License-Identifier: Apache-2.0

#include "core/dynamics/step.h"
#include "core/foam/locate.h"
#include "tests/core/foams.h"

#include <gtest/gtest.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace foam {
namespace {

using test::equilibrated_foam;
using test::is_valid;
using test::total_target;

// Returns the smallest bubble with 4 + turn % 3 sides. If there is none, tries the two other
// numbers of sides among 4, 5 and 6.
std::optional<BubbleId> next_target(const Foam& foam, int turn) {
    for (int k = 0; k < 3; ++k) {
        const std::vector<BubbleId> found = bubbles_of_sides(foam, 4 + (turn + k) % 3);
        if (!found.empty()) {
            return found.front();
        }
    }
    return std::nullopt;
}

void expect_exact(const Foam& foam, const StepSummary& summary) {
    ASSERT_TRUE(summary.equilibrium.converged());
    ASSERT_TRUE(is_valid(foam.network));
    EXPECT_LT(summary.equilibrium.area_error, 1e-9);
    EXPECT_LT(summary.equilibrium.angle_error, 1e-9);
    EXPECT_NEAR(total_target(foam) / foam.domain.area(), 1.0, 1e-12);
}

// Shrinks a bubble to the T2 area over the given number of steps, without diffusion. Expects that
// the bubble exists until the last step and then vanishes, and that each step ends in equilibrium.
void expect_collapse(Foam& foam, BubbleId target, int steps) {
    const Foam before = foam;
    const BubbleIdentity identity = foam.identities[target];
    const double area = foam.target_areas[target];
    const TopologyThresholds thresholds;
    for (int k = 1; k <= steps; ++k) {
        const double rest = area + (thresholds.t2_area - area) * k / steps;
        const DrivenBubble driven =
            k < steps ? DrivenBubble{identity, rest, false} : forced_collapse(identity, thresholds);
        const StepSummary summary = step(foam, 0.0, {{driven}}, {});
        ASSERT_NO_FATAL_FAILURE(expect_exact(foam, summary));
        EXPECT_EQ(foam.network.bubble_count(), before.network.bubble_count() - (k == steps));
    }
    EXPECT_EQ(find_bubble(foam, identity), std::nullopt);
    EXPECT_EQ(foam.time, before.time);
}

// Collapses bubbles one after another, as in Figure 7 of the paper but on a torus, until one bubble
// is left, which is its own neighbor.
void expect_collapse_to_the_last(std::uint64_t seed, int steps) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Foam foam = equilibrated_foam(66, seed);
    for (int turn = 0; foam.network.bubble_count() > 1; ++turn) {
        const std::optional<BubbleId> target = next_target(foam, turn);
        ASSERT_TRUE(target.has_value());
        ASSERT_NO_FATAL_FAILURE(expect_collapse(foam, *target, steps))
            << foam.network.bubble_count() << " bubbles";
    }
}

TEST(ForcedCollapse, CollapsesBubblesOfFourFiveAndSixSides) {
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        expect_collapse_to_the_last(seed, 1);
    }
}

TEST(ForcedCollapse, CollapsesThemSlowlyToo) {
    for (std::uint64_t seed = 7; seed <= 9; ++seed) {
        expect_collapse_to_the_last(seed, 8);
    }
}

// All other bubbles grow by the same factor. In addition, the last three neighbors share the last
// gas of the bubble, its T2 area.
TEST(ForcedCollapse, OthersShareTheGasInProportion) {
    Foam foam = equilibrated_foam(66, 1);
    const Foam before = foam;
    const BubbleId target{20};
    const double area = before.target_areas[target];
    step(foam, 0.0, {{forced_collapse(before.identities[target], {})}}, {});
    const double factor = (66.0 - 0.01) / (66.0 - area);
    int receivers = 0;
    for (const BubbleId bubble : foam.network.bubbles()) {
        const auto old = find_bubble(before, foam.identities[bubble]);
        const double excess = foam.target_areas[bubble] - factor * before.target_areas[*old];
        EXPECT_GT(excess, -1e-12);
        EXPECT_LT(excess, 0.01 + 1e-12);
        receivers += excess > 1e-12 ? 1 : 0;
    }
    EXPECT_EQ(receivers, 3);
}

// Two bubbles collapse while gas diffuses.
TEST(ForcedCollapse, WorksWhileGasDiffuses) {
    Foam foam = equilibrated_foam(66, 2);
    const StepSummary summary =
        step(foam, 5.0, {{forced_collapse(12, {}), forced_collapse(13, {})}}, {});
    expect_exact(foam, summary);
    EXPECT_NEAR(foam.time, 5.0, 1e-12);
    EXPECT_EQ(find_bubble(foam, 12), std::nullopt);
    EXPECT_EQ(find_bubble(foam, 13), std::nullopt);
}

TEST(ForcedCollapse, KeepsTheLastBubble) {
    Foam foam = equilibrated_foam(66, 3);
    StateChange change;
    for (BubbleIdentity identity = 0; identity < 66; ++identity) {
        change.driven.push_back(forced_collapse(identity, {}));
    }
    step(foam, 0.0, change, {});
    EXPECT_TRUE(is_valid(foam.network));
    EXPECT_GE(foam.network.bubble_count(), 1U);
}

}  // namespace
}  // namespace foam
