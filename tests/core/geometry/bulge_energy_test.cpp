// SPDX-License-Identifier: Apache-2.0

#include "core/geometry/bulge_energy.h"

#include "core/foam/random.h"
#include "core/geometry/film_energy.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace foam {
namespace {

constexpr double kPi = std::numbers::pi;

struct Film {
    FilmArc arc;
    double delta;
    double tension;
};

// Returns films with chords of 0.1 to 2 in every direction and half angles of up to 170 degrees in
// magnitude.
std::vector<Film> random_films() {
    Random random(3);
    std::vector<Film> films;
    while (films.size() < 1000) {
        const double c = 0.1 + 1.9 * random.uniform();
        const double direction = 2.0 * kPi * random.uniform();
        const double angle = (2.0 * random.uniform() - 1.0) * 17.0 / 18.0 * kPi;
        const double delta = 8.0 * random.uniform() - 4.0;
        const double tension = 0.2 + 3.0 * random.uniform();
        films.push_back(
            {{c * Vec2(std::cos(direction), std::sin(direction)), angle}, delta, tension});
    }
    return films;
}

BulgeEnergy energy_of(const Film& film) {
    return bulge_energy(film.arc, film.delta, film.tension);
}

// Returns the film with `by` added to an unknown: x (0) or y (1) of the chord, the half angle (2),
// or the pressure difference (3).
Film changed(Film film, int unknown, double by) {
    switch (unknown) {
        case 0:
        case 1:
            film.arc.chord[unknown] += by;
            break;
        case 2:
            film.arc.half_angle += by;
            break;
        default:
            film.delta += by;
    }
    return film;
}

Eigen::Vector4d gradient_of(const Film& film) {
    const BulgeEnergy energy = energy_of(film);
    return {
        energy.gradient.x(), energy.gradient.y(), energy.angle_derivative, -energy.segment_area};
}

Eigen::Matrix4d hessian_of(const Film& film) {
    const BulgeEnergyHessian hessian = bulge_energy_hessian(film.arc, film.delta, film.tension);
    Eigen::Matrix4d m = Eigen::Matrix4d::Zero();
    m.topLeftCorner<2, 2>() = hessian.chord_chord;
    m.block<2, 1>(0, 2) = hessian.chord_angle;
    m.block<2, 1>(0, 3) = hessian.chord_pressure;
    m.block<1, 2>(2, 0) = hessian.chord_angle.transpose();
    m.block<1, 2>(3, 0) = hessian.chord_pressure.transpose();
    m(2, 2) = hessian.angle_angle;
    m(2, 3) = m(3, 2) = hessian.pressure_angle;
    return m;
}

// A half circle of diameter 2 has the length pi and a segment of area pi / 2.
TEST(BulgeEnergy, IsKnownForAHalfCircle) {
    const BulgeEnergy energy = bulge_energy({{2.0, 0.0}, 0.5 * kPi}, 3.0, 5.0);
    EXPECT_DOUBLE_EQ(energy.segment_area, 0.5 * kPi);
    EXPECT_DOUBLE_EQ(energy.value, 5.0 * kPi - 3.0 * 0.5 * kPi);
}

TEST(BulgeEnergy, OfALaplaceYoungArcIsTheFilmEnergy) {
    for (const double s : {-0.98, -0.5, -1e-3, 0.0, 0.2, 0.7, 0.98}) {
        const Vec2 d(0.3, 0.4);
        const double tension = 1.7;
        const double delta = 2.0 * s * tension / d.norm();
        const FilmEnergy expected = film_energy(d, delta, tension);
        const BulgeEnergy energy = bulge_energy({d, std::asin(s)}, delta, tension);
        EXPECT_NEAR(energy.value, expected.value, 1e-15);
        EXPECT_NEAR(energy.segment_area, expected.segment_area, 1e-15);
        EXPECT_LT((energy.gradient - expected.gradient).norm(), 1e-14);
        EXPECT_NEAR(energy.angle_derivative, 0.0, 1e-15);
    }
}

// With steps of 1e-6, rounding errors are 1e-16 / 1e-6 times the energy. The tolerance is relative
// to the energy and the gradient.
TEST(BulgeEnergy, HasItsGradientByCentralDifferences) {
    constexpr double kStep = 1e-6;
    for (const Film& film : random_films()) {
        const Eigen::Vector4d gradient = gradient_of(film);
        const double size = 1.0 + std::abs(energy_of(film).value) + gradient.norm();
        for (int k = 0; k < 4; ++k) {
            const double difference = (energy_of(changed(film, k, kStep)).value -
                                       energy_of(changed(film, k, -kStep)).value) /
                                      (2.0 * kStep);
            EXPECT_NEAR(gradient[k], difference, 1e-8 * size) << "unknown " << k;
        }
    }
}

TEST(BulgeEnergy, HasItsHessianByCentralDifferences) {
    constexpr double kStep = 1e-6;
    for (const Film& film : random_films()) {
        const Eigen::Matrix4d hessian = hessian_of(film);
        for (int k = 0; k < 4; ++k) {
            const Eigen::Vector4d difference =
                (gradient_of(changed(film, k, kStep)) - gradient_of(changed(film, k, -kStep))) /
                (2.0 * kStep);
            EXPECT_LT((hessian.col(k) - difference).norm(), 1e-7 * (1.0 + hessian.norm()))
                << "unknown " << k << ", half angle " << film.arc.half_angle;
        }
    }
}

TEST(BulgeEnergy, VanishesWithItsChord) {
    const BulgeEnergy energy = bulge_energy({{0.0, 0.0}, 1.0}, 3.0, 1.0);
    EXPECT_EQ(energy.value, 0.0);
    EXPECT_EQ(energy.angle_derivative, 0.0);
    EXPECT_EQ(bulge_energy_hessian({{0.0, 0.0}, 1.0}, 3.0, 1.0).angle_angle, 0.0);
}

TEST(BulgeEnergy, LaplaceYoungErrorIsZeroOnBothSidesOfAHalfCircle) {
    for (const double angle : {0.3, kPi - 0.3}) {
        const double delta = 2.0 * std::sin(0.3) / 0.5;
        EXPECT_NEAR(laplace_young_error({{0.0, 0.5}, angle}, delta, 1.0), 0.0, 1e-15);
    }
    EXPECT_DOUBLE_EQ(laplace_young_error({{0.0, 0.5}, 0.5 * kPi}, 0.0, 1.0), 1.0);
}

}  // namespace
}  // namespace foam
