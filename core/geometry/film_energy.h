// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/geometry/film_arc.h"

namespace foam {

/// The contribution of one film to the function whose stationary point is equilibrium (E3):
/// energy(d, delta) = T length - delta segment_area. The arc is the Laplace-Young arc of the chord
/// d under the pressure difference delta = p_left - p_right.
///
/// If the half angle of the Laplace-Young arc would exceed the limit (kLargestSine), or if there is
/// no such arc (|s| >= 1), the half angle is clamped to the limit and `at_limit` is set. The
/// gradient is continuous there, because the energy is stationary in the half angle of a
/// Laplace-Young arc. So a state that is locally ill-defined has finite forces that lead out of it.
/// A state that has a film at the limit does not count as an equilibrium.
struct FilmEnergy {
    double half_angle = 0.0;
    double value = 0.0;
    double segment_area = 0.0;  // minus the derivative by the pressure difference
    Vec2 gradient{0.0, 0.0};    // derivative by the chord
    bool at_limit = false;
};

/// Second derivatives of FilmEnergy::value.
struct FilmEnergyHessian {
    Mat2 chord_chord = Mat2::Zero();
    Vec2 chord_pressure{0.0, 0.0};
    double pressure_pressure = 0.0;
};

/// The sine of the largest half angle of a film inside a foam, 80 degrees. This is well above the
/// 60 degrees of a two-sided bubble on a straight film, and well below 90 degrees, where the
/// derivatives diverge.
inline constexpr double kLargestSine = 0.984807753012208;

/// Returns the half angle of the Laplace-Young arc (E1), clamped to the limit (kLargestSine).
/// Precondition: the tension T = 2 gamma is positive.
double laplace_young_half_angle(double chord_length, double pressure_difference, double tension);

/// Returns the energy and its first derivatives, all zero if the chord is zero.
FilmEnergy film_energy(const Vec2& chord, double pressure_difference, double tension);

/// Returns the second derivatives of the energy, all zero if the chord is zero.
FilmEnergyHessian film_energy_hessian(const Vec2& chord,
                                      double pressure_difference,
                                      double tension);

}  // namespace foam
