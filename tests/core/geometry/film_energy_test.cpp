// SPDX-License-Identifier: Apache-2.0

#include "core/geometry/film_energy.h"

#include "core/foam/random.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace foam {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kRounding = 1e-15;

struct Film {
    Vec2 chord;
    double delta;
    double tension;
};

// Returns s of E1, without clamping.
double sine_of(const Film& film) {
    return 0.5 * film.delta * film.chord.norm() / film.tension;
}

FilmEnergy energy_of(const Film& film) {
    return film_energy(film.chord, film.delta, film.tension);
}

// Returns films with chords of 0.05 to 2 in every direction and s between -1.6 and 1.6. Four in ten
// are beyond the limit. Films within 0.01 of the limit are left out, because the second derivatives
// jump there.
std::vector<Film> random_films() {
    Random random(1);
    std::vector<Film> films;
    while (films.size() < 2000) {
        const double c = 0.05 * std::pow(40.0, random.uniform());
        const double angle = 2.0 * kPi * random.uniform();
        const double s = 3.2 * random.uniform() - 1.6;
        const double tension = 0.2 + 3.0 * random.uniform();
        if (std::abs(std::abs(s) - kLargestSine) > 0.01) {
            films.push_back(
                {c * Vec2(std::cos(angle), std::sin(angle)), 2.0 * s * tension / c, tension});
        }
    }
    return films;
}

template <class Value>
auto central_difference(const Value& value, double step) -> decltype(value(step)) {
    return (value(step) - value(-step)) / (2.0 * step);
}

TEST(FilmEnergy, OfAStraightFilmIsTensionTimesLength) {
    const FilmEnergy energy = film_energy({3.0, -4.0}, 0.0, 2.0);
    EXPECT_DOUBLE_EQ(energy.value, 10.0);
    EXPECT_NEAR(energy.gradient.x(), 1.2, kRounding);
    EXPECT_NEAR(energy.gradient.y(), -1.6, kRounding);
    EXPECT_EQ(energy.half_angle, 0.0);
    EXPECT_EQ(energy.segment_area, 0.0);
    EXPECT_FALSE(energy.at_limit);
}

// c = T = delta = 1 bend the film to radius 1. With s = 1/2, the half angle is 30 degrees, the
// length pi/3 and the segment pi/6 - sqrt(3)/4. The gradient is T cos 30 along the chord (E3).
TEST(FilmEnergy, IsKnownForASixthOfACircle) {
    const double segment = kPi / 6.0 - std::sqrt(3.0) / 4.0;
    const FilmEnergy energy = film_energy({0.0, 1.0}, 1.0, 1.0);
    EXPECT_NEAR(energy.half_angle, kPi / 6.0, kRounding);
    EXPECT_NEAR(energy.segment_area, segment, kRounding);
    EXPECT_NEAR(energy.value, kPi / 3.0 - segment, kRounding);
    EXPECT_NEAR(energy.gradient.x(), 0.0, kRounding);
    EXPECT_NEAR(energy.gradient.y(), std::sqrt(3.0) / 2.0, kRounding);
}

// The second derivatives of E3 for the same film. By the chord twice: -(delta/2) tan 30 along it
// and T cos 30 / c across it. By the chord and the pressure difference: -(c/2) tan 30. By the
// pressure difference twice: -(1/8) g'(1/2), with g'(1/2) = 4/sqrt(3) - 4 (2 pi/3 - sqrt(3)).
TEST(FilmEnergy, HessianIsKnownForASixthOfACircle) {
    const FilmEnergyHessian hessian = film_energy_hessian({0.0, 1.0}, 1.0, 1.0);
    const double tangent = 1.0 / std::sqrt(3.0);
    EXPECT_NEAR(hessian.chord_chord(0, 0), std::sqrt(3.0) / 2.0, kRounding);
    EXPECT_NEAR(hessian.chord_chord(1, 1), -0.5 * tangent, kRounding);
    EXPECT_NEAR(hessian.chord_chord(0, 1), 0.0, kRounding);
    EXPECT_NEAR(hessian.chord_chord(1, 0), 0.0, kRounding);
    EXPECT_NEAR(hessian.chord_pressure.x(), 0.0, kRounding);
    EXPECT_NEAR(hessian.chord_pressure.y(), -0.5 * tangent, kRounding);
    EXPECT_NEAR(hessian.pressure_pressure,
                -(4.0 * tangent - 4.0 * (2.0 * kPi / 3.0 - std::sqrt(3.0))) / 8.0,
                kRounding);
}

TEST(FilmEnergy, LaplaceYoungHalfAngleIsHeldAtTheLimit) {
    EXPECT_NEAR(laplace_young_half_angle(1.0, 1.0, 1.0), kPi / 6.0, kRounding);
    EXPECT_NEAR(laplace_young_half_angle(1.0, -1.0, 1.0), -kPi / 6.0, kRounding);
    EXPECT_NEAR(laplace_young_half_angle(2.0, 10.0, 1.0), 80.0 * kPi / 180.0, 1e-14);
    EXPECT_NEAR(laplace_young_half_angle(2.0, -10.0, 1.0), -80.0 * kPi / 180.0, 1e-14);
    EXPECT_EQ(laplace_young_half_angle(0.0, 10.0, 1.0), 0.0);
    EXPECT_FALSE(film_energy({1.0, 0.0}, 1.9, 1.0).at_limit);
    EXPECT_TRUE(film_energy({1.0, 0.0}, 1.98, 1.0).at_limit);
    EXPECT_TRUE(film_energy({1.0, 0.0}, -1.98, 1.0).at_limit);
}

TEST(FilmEnergy, IsTensionTimesLengthLessPressureTimesSegment) {
    for (const Film& film : random_films()) {
        const FilmEnergy energy = energy_of(film);
        const FilmArc arc{film.chord, energy.half_angle};
        const double expected = film.tension * arc_length(arc) - film.delta * segment_area(arc);
        const double size = film.tension * arc_length(arc);
        EXPECT_NEAR(energy.value, expected, 1e-14 * size);
        EXPECT_NEAR(energy.segment_area, segment_area(arc), 1e-14 * film.chord.squaredNorm());
        EXPECT_EQ(energy.at_limit, std::abs(sine_of(film)) > kLargestSine);
    }
}

// Among all arcs over a chord, the energy is stationary at the Laplace-Young arc. With h = 1e-4,
// the error of the central difference is h² = 1e-8 times a third derivative, which is up to 1e3
// near 80 degrees.
TEST(FilmEnergy, ArcIsStationaryInItsHalfAngle) {
    for (const Film& film : random_films()) {
        if (energy_of(film).at_limit) {
            continue;
        }
        const double alpha = energy_of(film).half_angle;
        const double slope = central_difference(
            [&](double h) {
                const FilmArc arc{film.chord, alpha + h};
                return film.tension * arc_length(arc) - film.delta * segment_area(arc);
            },
            1e-4);
        EXPECT_NEAR(slope, 0.0, 1e-7 * film.tension * film.chord.norm());
    }
}

// The steps are 1e-5 of the chord length. Near 80 degrees the third derivative of the energy by the
// chord is about T / (c² cos³) = 200 T/c²; its factor is h²/6. Rounding errors are 1e-16 / 1e-5.
TEST(FilmEnergy, GradientIsTheCentralDifferenceOfTheEnergy) {
    for (const Film& film : random_films()) {
        const double c = film.chord.norm();
        for (const Vec2& axis : {Vec2(1.0, 0.0), Vec2(0.0, 1.0)}) {
            const double difference = central_difference(
                [&](double h) {
                    return film_energy(film.chord + h * axis, film.delta, film.tension).value;
                },
                1e-5 * c);
            EXPECT_NEAR(energy_of(film).gradient.dot(axis), difference, 1e-7 * film.tension)
                << "s = " << sine_of(film);
        }
    }
}

TEST(FilmEnergy, SegmentAreaIsMinusTheCentralDifferenceByThePressure) {
    for (const Film& film : random_films()) {
        const double c = film.chord.norm();
        const double difference = central_difference(
            [&](double h) { return film_energy(film.chord, film.delta + h, film.tension).value; },
            1e-5 * film.tension / c);
        EXPECT_NEAR(energy_of(film).segment_area, -difference, 1e-7 * c * c)
            << "s = " << sine_of(film);
    }
}

// Each further derivative is larger by a factor of 1 / cos²(80 degrees). The tolerance is therefore
// 1e-6.
TEST(FilmEnergy, HessianIsTheCentralDifferenceOfTheGradient) {
    for (const Film& film : random_films()) {
        const double c = film.chord.norm();
        const FilmEnergyHessian hessian = film_energy_hessian(film.chord, film.delta, film.tension);
        for (const int column : {0, 1}) {
            const Vec2 axis = Vec2::Unit(column);
            const Vec2 difference = central_difference(
                [&](double h) -> Vec2 {
                    return film_energy(film.chord + h * axis, film.delta, film.tension).gradient;
                },
                1e-5 * c);
            EXPECT_LT((hessian.chord_chord.col(column) - difference).norm(),
                      1e-6 * film.tension / c)
                << "s = " << sine_of(film);
        }
    }
}

TEST(FilmEnergy, MixedHessianIsTheCentralDifferenceByThePressure) {
    for (const Film& film : random_films()) {
        const double c = film.chord.norm();
        const FilmEnergyHessian hessian = film_energy_hessian(film.chord, film.delta, film.tension);
        const double step = 1e-5 * film.tension / c;
        const Vec2 by_chord = central_difference(
            [&](double h) -> Vec2 {
                return film_energy(film.chord, film.delta + h, film.tension).gradient;
            },
            step);
        const double by_pressure = central_difference(
            [&](double h) {
                return -film_energy(film.chord, film.delta + h, film.tension).segment_area;
            },
            step);
        EXPECT_LT((hessian.chord_pressure - by_chord).norm(), 1e-6 * c) << sine_of(film);
        EXPECT_NEAR(hessian.pressure_pressure, by_pressure, 1e-6 * c * c * c / film.tension)
            << sine_of(film);
    }
}

// The two values of s differ from the limit by a relative 1e-12. Below the limit, the gradient
// changes by T tan 80 = 5.7 T and the area by c² g'/4 = 2.4 c² per unit of s; beyond it, both
// change less.
TEST(FilmEnergy, IsContinuousWithItsGradientAtTheLimit) {
    for (const double sign : {-1.0, 1.0}) {
        const double delta = sign * 2.0 * kLargestSine;
        const Vec2 chord(0.6, 0.8);
        const FilmEnergy below = film_energy(chord, delta * (1.0 - 1e-12), 1.0);
        const FilmEnergy above = film_energy(chord, delta * (1.0 + 1e-12), 1.0);
        EXPECT_FALSE(below.at_limit);
        EXPECT_TRUE(above.at_limit);
        EXPECT_NEAR(below.value, above.value, 2e-11);
        EXPECT_LT((below.gradient - above.gradient).norm(), 2e-11);
        EXPECT_NEAR(below.segment_area, above.segment_area, 2e-11);
    }
}

TEST(FilmEnergy, AZeroChordGivesZeros) {
    const FilmEnergy energy = film_energy({0.0, 0.0}, 3.0, 1.0);
    EXPECT_EQ(energy.value, 0.0);
    EXPECT_EQ(energy.gradient, Vec2(0.0, 0.0));
    EXPECT_EQ(energy.segment_area, 0.0);
    EXPECT_FALSE(energy.at_limit);
    const FilmEnergyHessian hessian = film_energy_hessian({0.0, 0.0}, 3.0, 1.0);
    EXPECT_EQ(hessian.chord_chord, Mat2::Zero());
    EXPECT_EQ(hessian.chord_pressure, Vec2(0.0, 0.0));
    EXPECT_EQ(hessian.pressure_pressure, 0.0);
}

// Returns 0 or a number of magnitude 1e-40 to 1e40. In this range the cube of a chord divided by a
// tension neither overflows nor underflows.
double any_real() {
    const double magnitude = std::pow(10.0, *rc::gen::inRange(-4000, 4001) * 0.01);
    return magnitude * *rc::gen::element(-1.0, 0.0, 1.0);
}

RC_GTEST_PROP(FilmEnergy, IsFiniteForAnyInput, ()) {
    const Vec2 chord(any_real(), any_real());
    const double delta = any_real();
    const double tension = std::pow(10.0, *rc::gen::inRange(-4000, 4001) * 0.01);
    const FilmEnergy energy = film_energy(chord, delta, tension);
    RC_ASSERT(std::isfinite(energy.value));
    RC_ASSERT(std::isfinite(energy.half_angle));
    RC_ASSERT(std::isfinite(energy.segment_area));
    RC_ASSERT(energy.gradient.allFinite());
    const FilmEnergyHessian hessian = film_energy_hessian(chord, delta, tension);
    RC_ASSERT(hessian.chord_chord.allFinite());
    RC_ASSERT(hessian.chord_pressure.allFinite());
    RC_ASSERT(std::isfinite(hessian.pressure_pressure));
}

// In the direction from head to tail, the film has the other bubble on its left, but the same
// energy.
RC_GTEST_PROP(FilmEnergy, IsTheSameFromBothSides, ()) {
    const Vec2 chord(any_real(), any_real());
    const double delta = any_real();
    const FilmEnergy forward = film_energy(chord, delta, 1.0);
    const FilmEnergy backward = film_energy(-chord, -delta, 1.0);
    RC_ASSERT(forward.value == backward.value);
    RC_ASSERT(forward.gradient == -backward.gradient);
    RC_ASSERT(forward.segment_area == -backward.segment_area);
    RC_ASSERT(forward.half_angle == -backward.half_angle);
}

}  // namespace
}  // namespace foam
