// SPDX-License-Identifier: Apache-2.0

#include "core/foam/stress.h"

#include "core/dynamics/shear.h"
#include "core/equilibrium/equilibrate.h"
#include "core/equilibrium/newton.h"
#include "core/foam/honeycomb.h"
#include "core/foam/measure.h"
#include "core/io/evolver_file.h"
#include "tests/core/foams.h"
#include "tests/core/io/data_file.h"
#include "tests/core/patches.h"
#include "tests/support/sample_foams.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace foam {
namespace {

constexpr double kRoot3 = std::numbers::sqrt3;
constexpr double kSide = 0.62040323940139973;  // side of a hexagon of area 1: sqrt(2 / (3 sqrt(3)))

Mat2 stress_of(const Foam& foam) {
    return mean_stress(snapshot(foam, 1));
}

/// Brings a foam to equilibrium without T1s, as exactly as rounding permits.
void equilibrate_exactly(Foam& foam) {
    const NewtonOptions options{.force_tolerance = 1e-13,
                                .area_tolerance = 1e-13,
                                .thresholds = {.t1_distance = 0.0, .t2_area = 0.0}};
    newton(foam, all_unknowns(foam.network), options);
    ASSERT_TRUE(equilibrium_errors(foam).are_below(1e-11));
}

/// Stretches a torus without shear by the factors x and y. Target areas grow with the torus.
void stretch(Foam& foam, double x, double y) {
    ASSERT_EQ(foam.domain.shear, 0.0);
    foam.domain.width *= x;
    foam.domain.height *= y;
    for (Vec2& position : foam.positions) {
        position = Vec2(x * position.x(), y * position.y());
    }
    for (double& area : foam.target_areas) {
        area *= x * y;
    }
}

using Deformation = std::function<void(Foam&, double)>;

/// Returns the derivative of the equilibrium energy by the strain, from a central difference of the
/// fourth order.
double energy_slope(const Foam& foam, const Deformation& deform) {
    constexpr double kStrain = 2e-3;
    const auto energy_at = [&](double strain) {
        Foam copy = foam;
        deform(copy, strain);
        equilibrate_exactly(copy);
        return energy(copy);
    };
    const double near = energy_at(kStrain) - energy_at(-kStrain);
    const double far = energy_at(2.0 * kStrain) - energy_at(-2.0 * kStrain);
    return (8.0 * near - far) / (12.0 * kStrain);
}

/// Returns a disordered foam under a shear stress, on a torus that is sheared by 0.3 of its height.
Foam sheared_foam() {
    Foam foam = test::polydisperse_foam(60, 4);
    for (int k = 0; k < 6; ++k) {
        shear(foam, 0.05);
        EXPECT_TRUE(equilibrate(foam, {}).converged());
    }
    equilibrate_exactly(foam);
    center_pressures(foam);
    return foam;
}

TEST(Stress, ShearStressIsTheSlopeOfTheEnergyInSimpleShear) {
    const Foam foam = sheared_foam();
    const double slope = energy_slope(foam, shear) / foam.domain.area();
    const double stress = stress_of(foam)(0, 1);
    EXPECT_GT(stress, 0.05);
    EXPECT_NEAR(slope / stress, 1.0, 1e-8);
}

// In pure shear by the strain e, the torus is stretched by 1 + e along x, and compressed by the
// same factor along y. The energy per area has the slope xx - yy.
TEST(Stress, NormalStressDifferenceIsTheSlopeOfTheEnergyInPureShear) {
    Foam foam = test::polydisperse_foam(60, 4);
    stretch(foam, 1.05, 1.0 / 1.05);
    equilibrate_exactly(foam);
    const double slope = energy_slope(
        foam, [](Foam& copy, double strain) { stretch(copy, 1.0 + strain, 1.0 / (1.0 + strain)); });
    const Mat2 stress = stress_of(foam);
    EXPECT_GT(std::abs(stress(0, 0) - stress(1, 1)), 0.05);
    EXPECT_NEAR(slope / foam.domain.area() / (stress(0, 0) - stress(1, 1)), 1.0, 1e-8);
}

/// Energies that Surface Evolver computed at four strains (tests/data/evolver/README.md).
struct StrainedEnergies {
    double minus_2;  // at -2 kEvolverStrain
    double minus_1;
    double plus_1;
    double plus_2;

    /// Returns the derivative by the strain at 0, from the central difference of the fourth order.
    double slope() const;
};

constexpr double kEvolverStrain = 0.002;

double StrainedEnergies::slope() const {
    return (8.0 * (plus_1 - minus_1) - (plus_2 - minus_2)) / (12.0 * kEvolverStrain);
}

// The energy of the foam is known with an error of about 1e-13, so that its slope per area has an
// error of about 1e-12. The truncation error is larger in the second case.
TEST(Stress, AgreesWithEnergiesOfSurfaceEvolver) {
    constexpr StrainedEnergies kSimpleShear{
        120.76305668352126, 120.76430084153323, 120.76715592363263, 120.76876684950216};
    constexpr StrainedEnergies kPureShear{
        120.78001968346172, 120.77260868926651, 120.75919258621705, 120.75318191342321};
    const Foam foam = read_evolver(test::data_file("evolver/torus64.dmp"), "torus64.dmp").foam;
    const Mat2 stress = stress_of(foam);
    EXPECT_NEAR(kSimpleShear.slope() / 64.0, stress(0, 1), 2e-11);
    EXPECT_NEAR(kPureShear.slope() / 64.0, stress(0, 0) - stress(1, 1), 2e-10);
}

// In a uniaxial extension, in which target areas grow with the torus, the slope is xx or yy. Their
// sum is the slope in an isotropic extension, in which the energy grows in proportion to lengths.
TEST(Stress, NormalStressesAreTheSlopesOfTheEnergyInExtension) {
    Foam foam = test::polydisperse_foam(60, 4);
    equilibrate_exactly(foam);
    center_pressures(foam);
    const double area = foam.domain.area();
    const Mat2 stress = stress_of(foam);
    const double along_x =
        energy_slope(foam, [](Foam& copy, double strain) { stretch(copy, 1.0 + strain, 1.0); });
    const double along_y =
        energy_slope(foam, [](Foam& copy, double strain) { stretch(copy, 1.0, 1.0 + strain); });
    EXPECT_NEAR(along_x / area / stress(0, 0), 1.0, 1e-8);
    EXPECT_NEAR(along_y / area / stress(1, 1), 1.0, 1e-8);
    EXPECT_NEAR(energy(foam) / area / stress.trace(), 1.0, 1e-12);
}

// Three directions of films, at 60 degrees to each other, have the same weight. The energy per
// bubble is T sqrt(2 sqrt(3)).
TEST(Stress, OfAHoneycombIsIsotropic) {
    Foam foam = honeycomb(4, 4);
    foam.film_tension = 3.0;
    const Mat2 stress = stress_of(foam);
    const double half_energy = 0.5 * 3.0 * std::sqrt(2.0 * kRoot3);
    EXPECT_NEAR(stress(0, 0), half_energy, 1e-13);
    EXPECT_NEAR(stress(1, 1), half_energy, 1e-13);
    EXPECT_NEAR(stress(0, 1), 0.0, 1e-13);
    for (double& pressure : foam.pressures) {
        pressure = 0.75;
    }
    EXPECT_NEAR(stress_of(foam)(0, 0), half_energy - 0.75, 1e-13);
    EXPECT_NEAR(stress_of(foam)(0, 1), 0.0, 1e-13);
}

// The three films per bubble form the Steiner tree of a triangle of the lattice, whose length L is
// given by L² = (a² + b² + c²) / 2 + 2 sqrt(3) area, for sides a, b, c. In simple shear this is
// L = 3 l sqrt(1 + strain² / 4), for films of length l at rest, so that the stress is
// G strain / sqrt(1 + strain² / 4) with Princen's modulus G = T / (2 sqrt(3) l) (E11).
TEST(Stress, OfAShearedHoneycombIsPrincens) {
    const double modulus = 1.0 / (2.0 * kRoot3 * kSide);
    for (const double strain : {-0.3, 0.001, 0.1, 0.4}) {
        Foam foam = honeycomb(4, 4);
        shear(foam, strain);
        equilibrate_exactly(foam);
        const double expected = modulus * strain / std::sqrt(1.0 + 0.25 * strain * strain);
        EXPECT_NEAR(stress_of(foam)(0, 1), expected, 1e-12) << strain;
    }
}

// If the torus is stretched by exp(e) along x and by exp(-e) along y, the length of the Steiner
// tree is 3 l cosh e, so that xx - yy is 4 G sinh e.
TEST(Stress, OfAStretchedHoneycombIsPrincens) {
    const double modulus = 1.0 / (2.0 * kRoot3 * kSide);
    for (const double strain : {-0.2, 0.001, 0.2}) {
        Foam foam = honeycomb(4, 4);
        stretch(foam, std::exp(strain), std::exp(-strain));
        equilibrate_exactly(foam);
        const Mat2 stress = stress_of(foam);
        const double expected = 4.0 * modulus * std::sinh(strain);
        EXPECT_NEAR(stress(0, 0) - stress(1, 1), expected, 1e-12) << strain;
        EXPECT_NEAR(stress(0, 1), 0.0, 1e-12) << strain;
    }
}

TEST(Stress, TurnsWithTheFoam) {
    const Frame frame = snapshot(sheared_foam(), 1);
    const double angle = 0.7;
    const Mat2 turn{{std::cos(angle), -std::sin(angle)}, {std::sin(angle), std::cos(angle)}};
    Frame turned = frame;
    for (FilmArc& arc : turned.arcs) {
        arc.chord = turn * arc.chord;
    }
    const Mat2 expected = turn * mean_stress(frame) * turn.transpose();
    EXPECT_LT((mean_stress(turned) - expected).norm(), 1e-13);
}

// No force acts from outside on a patch in equilibrium.
TEST(Stress, OfAPatchInEquilibriumIsZero) {
    for (Foam foam : {test::double_bubble(1.0, 2.0), test::patch_foam(40, 3)}) {
        ASSERT_TRUE(equilibrate(foam, {}).converged());
        foam.lone_bubbles.push_back({.identity = 99, .center = {9.0, 9.0}, .target_area = 2.0});
        EXPECT_LT(stress_of(foam).norm(), 1e-9);
    }
}

TEST(Stress, OfAPatchWithoutBubblesIsZero) {
    EXPECT_EQ(stress_of(test::circles({})).norm(), 0.0);
    const LoneBubble lone{.identity = 3, .center = {1.0, 2.0}, .target_area = 2.0};
    EXPECT_EQ(stress_of(test::circles({lone})).norm(), 0.0);
}

// Returns the stress of a bubble, times its area, with half of each inner film around it and the
// whole of each outer film.
Mat2 stress_times_area(const Frame& frame, BubbleId bubble) {
    Mat2 films = Mat2::Zero();
    for (const HalfEdgeId h : frame.network.around(bubble)) {
        const double share = frame.network.is_outer(film_of(h)) ? 1.0 : 0.5;
        films += share * tangent_tensor(frame.arc(h));
    }
    const FrameBubble& gas = frame.bubbles[bubble];
    return frame.film_tension * films - gas.area * gas.pressure * Mat2::Identity();
}

TEST(Stress, IsTheMeanOfTheStressesOfBubbles) {
    for (const Foam& foam : {test::bent_foam(3, 1.0, 5),
                             test::bent_foam(40, 2.0, 5),
                             test::patch_foam(30, 2),
                             test::ring_foam()}) {
        const Frame frame = snapshot(foam, 1);
        Mat2 sum = Mat2::Zero();
        double area = 0.0;
        for (const BubbleId bubble : frame.network.bubbles()) {
            sum += stress_times_area(frame, bubble);
            area += frame.bubbles[bubble].area;
        }
        EXPECT_LT((sum / area - mean_stress(frame)).norm(), 1e-13);
    }
}

}  // namespace
}  // namespace foam
