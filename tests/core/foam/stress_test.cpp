// SPDX-License-Identifier: Apache-2.0

#include "core/foam/stress.h"

#include "core/dynamics/shear.h"
#include "core/equilibrium/equilibrate.h"
#include "core/foam/honeycomb.h"
#include "core/foam/measure.h"
#include "tests/support/sample_foams.h"

#include <gtest/gtest.h>

#include <numbers>

namespace foam {
namespace {

// Returns the sum of t tᵀ over small parts of an arc, by the midpoint rule.
Mat2 integral_by_parts(const FilmArc& arc, int parts) {
    Mat2 sum = Mat2::Zero();
    for (int k = 0; k < parts; ++k) {
        const Vec2 before = point_at(arc, static_cast<double>(k) / parts);
        const Vec2 after = point_at(arc, static_cast<double>(k + 1) / parts);
        const Vec2 tangent = (after - before).normalized();
        sum += arc_length(arc) / parts * tangent * tangent.transpose();
    }
    return sum;
}

TEST(Stress, TangentIntegralIsTheSumOverSmallParts) {
    for (const double angle : {0.0, 1e-9, -0.3, 1.0, 1.5707963267948966, -2.0, 3.0}) {
        const FilmArc arc{{0.7, -0.4}, angle};
        EXPECT_LT((tangent_integral(arc) - integral_by_parts(arc, 4000)).norm(), 1e-5) << angle;
        EXPECT_NEAR(tangent_integral(arc).trace(), arc_length(arc), 1e-14 * arc_length(arc));
    }
}

// Returns the energy of the foam after a shear, in equilibrium without T1s.
double energy_after(Foam foam, double strain) {
    shear(foam, strain);
    EquilibriumOptions options;
    options.tolerance = 1e-11;
    options.thresholds.t1_distance = 1e-9;
    options.relaxes_first = false;
    const EquilibriumSummary found = equilibrate(foam, options);
    EXPECT_EQ(found.status, EquilibriumStatus::Converged);
    EXPECT_EQ(found.t1, 0);
    return energy(foam);
}

// The shear stress is the derivative of the energy per area with respect to the strain. The
// difference quotient of five points has an error of the order of h^4.
TEST(Stress, IsTheDerivativeOfTheEnergyWithRespectToShear) {
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        const Foam foam = test::polydisperse_foam(60, seed);
        constexpr double h = 2e-3;
        const double slope = (8.0 * (energy_after(foam, h) - energy_after(foam, -h)) -
                              (energy_after(foam, 2.0 * h) - energy_after(foam, -2.0 * h))) /
                             (12.0 * h);
        const Mat2 found = stress(snapshot(foam, 1));
        EXPECT_NEAR(found(0, 1), slope / foam.domain.area(), 1e-8) << seed;
        EXPECT_EQ(found(0, 1), found(1, 0));
    }
}

// If all lengths grow by the factor 1 + e, the energy of the films does, too, and the gas does the
// work p dA. The trace of the stress is (T l - 2 p A) / area.
TEST(Stress, TraceIsThatOfFilmsAndGas) {
    const Foam foam = test::polydisperse_foam(60, 4);
    const Frame frame = snapshot(foam, 1);
    double gas = 0.0;
    for (const BubbleId bubble : frame.network.bubbles()) {
        gas += frame.bubbles[bubble].pressure * frame.bubbles[bubble].area;
    }
    EXPECT_NEAR(stress(frame).trace(), (energy(foam) - 2.0 * gas) / foam.domain.area(), 1e-12);
}

// Nothing pulls at a free patch, so that its mean stress is 0 (the virial theorem).
TEST(Stress, OfAPatchInEquilibriumIsZero) {
    EXPECT_LT(stress(snapshot(test::patch_foam(2, 1), 1)).norm(), 1e-9);
    EXPECT_LT(stress(snapshot(test::patch_foam(40, 1), 1)).norm(), 1e-9);
    EXPECT_LT(
        stress(snapshot(test::circles({{.center = {1.0, 2.0}, .target_area = 3.0}}), 1)).norm(),
        1e-15);
}

// A dry honeycomb whose hexagons have the side a has the shear modulus T / (2 sqrt(3) a) (Princen,
// J. Colloid Interface Sci. 91, 160, 1983, in terms of the film tension T).
TEST(Stress, OfAShearedHoneycombGivesItsShearModulus) {
    Foam foam = honeycomb(4, 4);
    constexpr double strain = 1e-4;
    shear(foam, strain);
    EquilibriumOptions options;
    options.tolerance = 1e-12;
    ASSERT_TRUE(equilibrate(foam, options).converged());
    const double side = std::sqrt(2.0 / (3.0 * std::numbers::sqrt3));
    const double modulus = foam.film_tension / (2.0 * std::numbers::sqrt3 * side);
    EXPECT_NEAR(stress(snapshot(foam, 1))(0, 1) / strain, modulus, 1e-6 * modulus);
}

}  // namespace
}  // namespace foam
