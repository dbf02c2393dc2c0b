// SPDX-License-Identifier: Apache-2.0

#include "core/dynamics/displacement.h"

#include "core/dynamics/step.h"
#include "core/foam/honeycomb.h"
#include "core/foam/polygon_mesh.h"
#include "tests/core/foams.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace foam {
namespace {

using test::equilibrated_foam;
using test::is_valid;

StateChange push_of(const Vec2& center, double radius, const Vec2& by) {
    StateChange change;
    change.pushes.push_back({center, radius, by});
    return change;
}

// The push is so short that it is made in one small step. A junction moves by the weight of E9
// times the push. The weight is 1 at the center, 9/16 at half the radius, and 0 beyond the radius.
TEST(Displacement, FadesOutTowardsItsEdge) {
    const Foam before = honeycomb(8, 8);
    const JunctionId middle{40};
    const Vec2 center = before.positions[middle];
    Foam foam = before;
    EXPECT_EQ(displace(foam, {center, 2.0, {0.01, 0.0}}, {}), 0);
    for (const JunctionId junction : before.network.junctions()) {
        const double u =
            before.domain.nearest_copy(before.positions[junction] - center).norm() / 2.0;
        const double weight = u < 1.0 ? (1.0 - u * u) * (1.0 - u * u) : 0.0;
        const Vec2 moved =
            foam.domain.nearest_copy(foam.positions[junction] - before.positions[junction]);
        EXPECT_NEAR(moved.x(), 0.01 * weight, 1e-14);
        EXPECT_NEAR(moved.y(), 0.0, 1e-14);
    }
}

// Without T1, the foam returns to the same equilibrium after the push.
TEST(Displacement, ASmallPushIsReversibleWithoutT1) {
    Foam foam = equilibrated_foam(60, 4);
    const Foam before = foam;
    const StepSummary summary = step(foam, 0.0, push_of({2.0, 3.0}, 2.0, {0.05, 0.02}), {});
    ASSERT_TRUE(summary.equilibrium.converged());
    ASSERT_EQ(summary.equilibrium.t1, 0);
    for (const BubbleId bubble : foam.network.bubbles()) {
        EXPECT_NEAR(foam.pressures[bubble], before.pressures[bubble], 1e-7);
    }
}

TEST(Displacement, ALargePushRearrangesTheFoam) {
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        Foam foam = equilibrated_foam(60, seed);
        int flips = 0;
        for (int k = 0; k < 4; ++k) {
            const double angle = 0.5 * std::numbers::pi * k;
            const StepSummary summary =
                step(foam,
                     0.0,
                     push_of({1.0 * k, 7.0}, 2.5, {2.0 * std::cos(angle), 2.0 * std::sin(angle)}),
                     {});
            ASSERT_TRUE(summary.equilibrium.converged()) << seed << ' ' << k;
            ASSERT_TRUE(is_valid(foam.network)) << seed << ' ' << k;
            EXPECT_LT(summary.equilibrium.area_error, 1e-9);
            EXPECT_LT(summary.equilibrium.angle_error, 1e-9);
            flips += summary.equilibrium.t1;
        }
        EXPECT_GT(flips, 0) << seed;
        EXPECT_EQ(foam.network.bubble_count(), 60U);
    }
}

// A narrow triangular hole between three large cells. The push shortens two of its films at once;
// the first of them closes the hole, which removes all three.
TEST(Displacement, APushMayCloseAHole) {
    Foam foam =
        foam_from_mesh({{{0.2, 0.1}, {-0.3, 0.0}, {0.0, -0.1}, {2.6, 1.5}, {-2.6, 1.5}, {0, -3}},
                        {{0, 3, 4, 1}, {1, 4, 5, 2}, {2, 5, 3, 0}}});
    ASSERT_TRUE(is_valid(foam.network));
    ASSERT_EQ(foam.network.film_count(), 9U);
    EXPECT_EQ(displace(foam, {{-0.9, 0.0}, 1.2, {1.0, 0.0}}, {}), 1);
    EXPECT_TRUE(is_valid(foam.network));
    EXPECT_EQ(foam.network.film_count(), 6U);
}

}  // namespace
}  // namespace foam
