// Free clusters in equilibrium, against closed forms.
#include "core/equilibrium/equilibrate.h"
#include "core/foam/measure.h"
#include "tests/core/foams.h"
#include "tests/core/patches.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace foam {
namespace {

constexpr double kTolerance = 1e-9;
constexpr double kPi = std::numbers::pi;
const double kRoot3 = std::sqrt(3.0);

// In a free cluster with the outer pressure 0 the energy is twice the sum of pressure times area:
// a change of scale by 1 + e adds e times the energy, and does 2 e p A of work on each bubble.
double twice_pressure_times_area(const Foam& foam) {
    double sum = 0.0;
    for (const BubbleId bubble : foam.network.bubbles()) {
        sum += 2.0 * foam.pressures[bubble] * foam.target_areas[bubble];
    }
    return sum;
}

Foam settled(Foam foam, bool relaxes_first) {
    EquilibriumOptions options;
    options.relaxes_first = relaxes_first;
    const EquilibriumSummary summary = equilibrate(foam, options);
    EXPECT_TRUE(summary.converged());
    EXPECT_TRUE(test::is_valid(foam.network));
    EXPECT_LT(equilibrium_errors(foam).arc, kTolerance);
    EXPECT_EQ(foam.pressures[foam.network.ghost()], 0.0);
    EXPECT_NEAR(summary.energy / twice_pressure_times_area(foam), 1.0, kTolerance);
    return foam;
}

void expect_half_angles(const Foam& foam, double degrees) {
    for (const FilmId film : foam.network.films()) {
        if (foam.network.is_outer(film)) {
            const HalfEdgeId h = forward_side(film);
            const HalfEdgeId inside = foam.network.left(h) == foam.network.ghost() ? twin(h) : h;
            EXPECT_NEAR(film_arc(foam, inside).half_angle * 180.0 / kPi, degrees, 1e-6);
        }
    }
}

TEST(EquilibratePatch, TwoEqualBubbles) {
    for (const bool relaxes_first : {true, false}) {
        const Foam foam = settled(test::double_bubble(1.0, 1.0), relaxes_first);
        EXPECT_NEAR(energy(foam), 6.359129253960, kTolerance);
        EXPECT_NEAR(foam.pressures[BubbleId{0}], 1.589782313490, kTolerance);
        expect_half_angles(foam, 120.0);
    }
}

// As in FilmArc, ThreeBubbleCluster: the outer films are half circles, where Laplace-Young alone
// does not tell the half angle.
TEST(EquilibratePatch, ThreeEqualBubbles) {
    const double length = 1.0 / std::sqrt(kRoot3 / 4.0 + 3.0 * kPi / 8.0);
    for (const bool relaxes_first : {true, false}) {
        const Foam foam = settled(test::triple_bubble(1.0), relaxes_first);
        EXPECT_NEAR(foam.pressures[BubbleId{0}], 2.0 / (kRoot3 * length), kTolerance);
        expect_half_angles(foam, 90.0);
    }
}

// The bubble in the middle is a hexagon of straight films of length a, 3 sqrt(3)/2 a² = 1, and all
// pressures are the same. A petal is what the triangle of side R, from the middle to two outer
// junctions, has beyond a sixth of the hexagon, and a segment of half angle 60 degrees on it:
//     sqrt(3)/4 (R² - a²) + R²/4 (pi/3 - sqrt(3)/4) / (3/4) = 1.
// So p = 2 sin 60 / R, and the films are 6 R of straight ones and 6 arcs of R (pi/3) / sin 60.
TEST(EquilibratePatch, AHexagonalClusterOfSeven) {
    const double segment = (kPi / 3.0 - kRoot3 / 4.0) / 3.0;
    const double radius = std::sqrt((1.0 + 1.0 / 6.0) / (kRoot3 / 4.0 + segment));
    for (const bool relaxes_first : {true, false}) {
        const Foam foam = settled(test::flower(1.0), relaxes_first);
        EXPECT_NEAR(energy(foam), 6.0 * radius * (1.0 + 2.0 * kPi / (3.0 * kRoot3)), kTolerance);
        for (const BubbleId bubble : foam.network.bubbles()) {
            EXPECT_NEAR(foam.pressures[bubble], kRoot3 / radius, kTolerance);
        }
        expect_half_angles(foam, 60.0);
    }
}

TEST(EquilibratePatch, OfOtherTensions) {
    Foam foam = test::triple_bubble(2.0);
    foam.film_tension = 0.3;
    foam = settled(foam, true);
    Foam unit = settled(test::triple_bubble(1.0), true);
    EXPECT_NEAR(energy(foam) / energy(unit), 0.3 * std::sqrt(2.0), kTolerance);
}

// Any number of threads, and a patch that has been turned and moved, has the same energy.
TEST(EquilibratePatch, IsFreeToMove) {
    Foam foam = test::chain();
    Foam moved = foam;
    for (const JunctionId junction : moved.network.junctions()) {
        const Vec2 at = moved.positions[junction];
        moved.positions[junction] = Vec2(-100.0 - at.y(), 30.0 + at.x());
    }
    foam = settled(foam, true);
    moved = settled(moved, true);
    EXPECT_NEAR(energy(foam), energy(moved), kTolerance);
}

}  // namespace
}  // namespace foam
