// SPDX-License-Identifier: Apache-2.0

#include "core/dynamics/shear_modulus.h"

#include "core/dynamics/shear.h"
#include "core/equilibrium/equilibrate.h"
#include "core/foam/honeycomb.h"
#include "core/foam/stress.h"
#include "tests/core/foams.h"
#include "tests/support/sample_foams.h"

#include <gtest/gtest.h>

#include <cmath>

namespace foam {
namespace {

// Princen's modulus of films of length l is T / (2 sqrt(3) l), where l is the square root of
// 2 / (3 sqrt(3)) for bubbles of area 1 (E11).
TEST(ShearModulus, OfAHoneycombIsPrincens) {
    Foam foam = honeycomb(4, 4);
    foam.film_tension = 3.0;
    const double side = std::sqrt(2.0 / (3.0 * std::sqrt(3.0)));
    const double expected = 3.0 / (2.0 * std::sqrt(3.0) * side);
    EXPECT_NEAR(shear_modulus(foam).value() / expected, 1.0, 1e-7);
    EXPECT_NEAR(shear_modulus(snapshot(foam, 1)).value() / expected, 1.0, 1e-7);
}

// The shear stress of a disordered foam grows by the modulus times the strain, as long as there is
// no T1.
TEST(ShearModulus, IsTheSlopeOfTheStressInSteps) {
    Foam foam = test::equilibrated_foam(60, 4);
    const double modulus = shear_modulus(foam).value();
    const double before = mean_stress(snapshot(foam, 1))(0, 1);
    const double strain = 1e-3;
    shear(foam, strain);
    const EquilibriumSummary summary = equilibrate(foam, {.relaxes_first = false});
    ASSERT_TRUE(summary.converged());
    ASSERT_EQ(summary.t1, 0);
    const double after = mean_stress(snapshot(foam, 1))(0, 1);
    EXPECT_NEAR((after - before) / strain / modulus, 1.0, 0.01);
    EXPECT_GT(modulus, 0.1);
    EXPECT_LT(modulus, 1.0);
}

TEST(ShearModulus, DoesNotDependOnThreads) {
    const Foam foam = test::equilibrated_foam(300, 4);
    EXPECT_EQ(shear_modulus(foam, 1), shear_modulus(foam, 3));
}

TEST(ShearModulus, OnlyATorusInEquilibriumHasOne) {
    EXPECT_FALSE(shear_modulus(test::patch_foam(20, 1)));
    EXPECT_FALSE(shear_modulus(test::raw_foam(20, 1)));
}

}  // namespace
}  // namespace foam
