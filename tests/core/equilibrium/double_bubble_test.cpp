// SPDX-License-Identifier: Apache-2.0

// Tests two bubbles in a raft of their own against their equilibrium in closed form.
#include "core/equilibrium/equilibrate.h"
#include "core/foam/measure.h"
#include "core/foam/rafts.h"
#include "tests/core/foams.h"
#include "tests/core/patches.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace foam {
namespace {

constexpr double kThird = 2.0 * std::numbers::pi / 3.0;  // 120 degrees
constexpr int kBisectionSteps = 60;  // halvings of the range of beta, down to rounding

double segment(double half_angle) {
    return arc_shape(half_angle).segment;
}

// Returns four times the area of the smaller bubble, divided by the square of the chord length.
// `beta` is the half angle of the film between the bubbles.
double small_area(double beta) {
    return segment(kThird - beta) + segment(beta);
}

// Returns the same quotient for the larger bubble.
double large_area(double beta) {
    return segment(kThird + beta) - segment(beta);
}

// Returns the half angle of the film between the bubbles for the given ratio of the smaller to the
// larger area, by bisection. It is 0 for equal bubbles and nearly 60 degrees for a tiny bubble on a
// large one.
double inner_half_angle(double ratio) {
    double low = 0.0;
    double high = 0.5 * kThird;
    for (int k = 0; k < kBisectionSteps; ++k) {
        const double middle = 0.5 * (low + high);
        (small_area(middle) > ratio * large_area(middle) ? low : high) = middle;
    }
    return low;
}

// Sets the length of the chord of h. Keeps the middle and the direction of the chord.
void set_chord(Foam& foam, HalfEdgeId h, double length) {
    const Vec2 d = chord(foam, h);
    const Vec2 direction = d == Vec2::Zero() ? Vec2(1.0, 0.0) : Vec2(d.normalized());
    Vec2& tail = foam.positions[foam.network.tail(h)];
    Vec2& head = foam.positions[foam.network.head(h)];
    const Vec2 middle = 0.5 * (tail + head);
    tail = middle - 0.5 * length * direction;
    head = middle + 0.5 * length * direction;
}

// Sets the outer film and the pressure of the bubble on the left of `inner`, the film between the
// two bubbles.
void set_bubble(Foam& foam, HalfEdgeId inner, double half_angle, double chord_length) {
    const HalfEdgeId outer = foam.network.next(inner);
    set_half_angle(foam, outer, half_angle);
    foam.pressures[foam.network.left(inner)] =
        2.0 * foam.film_tension * std::sin(half_angle) / chord_length;
}

// Brings a raft of two bubbles to equilibrium in closed form. Keeps the middle and the direction of
// the chord, which all three films share. The film between the bubbles bulges into the larger
// bubble with the half angle beta. The films meet at 120 degrees if the outer films have half
// angles of 120 degrees - beta (smaller bubble) and 120 degrees + beta (larger bubble). The ratio
// of the areas determines beta (E1; h is ArcShape::segment):
//     4 A_small / c² = h(120 - beta) + h(beta),   4 A_large / c² = h(120 + beta) - h(beta).
void equilibrate_double_bubble(Foam& foam, FilmId film) {
    HalfEdgeId h = forward_side(film);
    if (foam.target_areas[foam.network.left(h)] > foam.target_areas[foam.network.right(h)]) {
        h = twin(h);
    }
    const double small = foam.target_areas[foam.network.left(h)];
    const double large = foam.target_areas[foam.network.right(h)];
    const double beta = inner_half_angle(small / large);
    const double length = 2.0 * std::sqrt(small / small_area(beta));
    set_chord(foam, h, length);
    set_bubble(foam, h, kThird - beta, length);
    set_bubble(foam, twin(h), kThird + beta, length);
}

FilmId inner_film(const Foam& foam) {
    return film_of(test::side_between(foam.network, BubbleId{0}, BubbleId{1}));
}

TEST(DoubleBubble, IsARaftOfTwo) {
    const Foam two = test::double_bubble(1.0, 1.0);
    for (const FilmId film : two.network.films()) {
        EXPECT_EQ(is_inside_double_bubble(two.network, film), film == inner_film(two));
    }
    const Foam four = test::chain();
    for (const FilmId film : four.network.films()) {
        EXPECT_FALSE(is_inside_double_bubble(four.network, film));
    }
}

// The errors of the equilibrium in closed form are rounding errors, whichever bubble is the larger
// one. If an outer film is nearly a full circle, the area amplifies the rounding error of its half
// angle.
TEST(DoubleBubble, ReachesEquilibriumInClosedForm) {
    for (const double ratio : {1.0, 0.5, 3.0, 100.0, 0.001}) {
        Foam foam = test::double_bubble(0.7, 0.7 * ratio);
        foam.film_tension = 1.3;
        equilibrate_double_bubble(foam, inner_film(foam));
        const EquilibriumErrors errors = equilibrium_errors(foam);
        EXPECT_LT(errors.area, 1e-12) << ratio;
        EXPECT_LT(errors.angle, 1e-13) << ratio;
        EXPECT_LT(errors.arc, 1e-13) << ratio;
    }
}

TEST(DoubleBubble, AgreesWithTheSolver) {
    for (const double ratio : {1.0, 0.3, 30.0}) {
        Foam closed = test::double_bubble(1.0, ratio);
        equilibrate_double_bubble(closed, inner_film(closed));
        Foam solved = closed;
        for (Vec2& position : solved.positions) {
            position *= 1.02;
        }
        for (double& angle : solved.half_angles) {
            angle *= 0.98;
        }
        EquilibriumOptions options;
        options.relaxes_first = false;
        const EquilibriumSummary summary = equilibrate(solved, options);
        EXPECT_TRUE(summary.converged());
        EXPECT_EQ(summary.sweeps, 0);
        EXPECT_NEAR(summary.energy, energy(closed), 1e-10);
        EXPECT_NEAR(solved.pressures[BubbleId{1}], closed.pressures[BubbleId{1}], 1e-9);
    }
}

}  // namespace
}  // namespace foam
