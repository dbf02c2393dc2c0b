// SPDX-License-Identifier: Apache-2.0

#include "core/dynamics/coarsening.h"

#include "core/foam/honeycomb.h"
#include "tests/core/foams.h"

#include <gtest/gtest.h>

#include <numbers>

namespace foam {
namespace {

constexpr double kPi = std::numbers::pi;

// gamma = T/2 = 1/2 and kappa = 0.3: (2 pi/3) (1/2) (0.3) (n - 6) = (pi/10) (n - 6).
TEST(Coarsening, GrowthRateIsVonNeumanns) {
    Foam foam = honeycomb(4, 4);
    const CoarseningOptions options{.kappa = 0.3};
    for (int sides = 3; sides <= 9; ++sides) {
        foam.network.set_sides(BubbleId{2}, sides);
        EXPECT_NEAR(growth_rate(foam, BubbleId{2}, options), kPi / 10.0 * (sides - 6), 1e-15);
    }
}

TEST(Coarsening, GrowthRateIsInProportionToTensionAndKappa) {
    Foam foam = honeycomb(4, 4);
    foam.network.set_sides(BubbleId{2}, 9);
    foam.film_tension = 4.0;  // gamma = 2: (2 pi/3) 2 (0.25) 3 = pi
    EXPECT_NEAR(growth_rate(foam, BubbleId{2}, {.kappa = 0.25}), kPi, 1e-15);
}

// Bubble 5 has 3 sides; bubbles 10, 4 and 2 have 5 sides; bubbles 6, 9 and 1 have 8 sides. With
// kappa = 3/pi the growth rate is n - 6.
TEST(Coarsening, DiffuseChangesTheTargetsOnly) {
    Foam foam = test::honeycomb_around(3);
    const Foam before = foam;
    diffuse(foam, 0.1, {.kappa = 3.0 / kPi});
    EXPECT_NEAR(foam.target_areas[BubbleId{5}], 0.7, 1e-14);
    EXPECT_NEAR(foam.target_areas[BubbleId{10}], 0.9, 1e-14);
    EXPECT_NEAR(foam.target_areas[BubbleId{6}], 1.2, 1e-14);
    EXPECT_EQ(foam.target_areas[BubbleId{0}], before.target_areas[BubbleId{0}]);
    foam.target_areas = before.target_areas;
    EXPECT_TRUE(test::are_same(foam, before));
}

// The sum of n - 6 over all bubbles is 0 (Euler), so that the total area does not change. A single
// target area may become negative.
TEST(Coarsening, DiffuseKeepsTheTotal) {
    for (const int bubbles : {2, 5, 200}) {
        Foam foam = test::raw_foam(bubbles, 3);
        diffuse(foam, 2.0, {.kappa = 1.0});
        EXPECT_NEAR(test::total_target(foam) / foam.domain.area(), 1.0, 1e-13);
    }
}

}  // namespace
}  // namespace foam
