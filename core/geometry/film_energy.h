// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/geometry/film_arc.h"

namespace foam {

/// The contribution of one inner film to the function L of E3 in core/EQUATIONS.md (bulge_energy.h
/// has the contribution of an outer film):
///     energy(d, delta) = T length - delta segment_area
/// Equilibrium is a stationary point of L. T is the film tension, d the chord, and
/// delta = p_left - p_right the pressure difference. The film is a Laplace-Young arc: the arc that
/// satisfies Laplace-Young's law (E1). The sine of its half angle is s = delta |d| / 2T.
///
/// The half angle of the Laplace-Young arc is limited to 80 degrees. If it would exceed this limit
/// (|s| > kLargestSine), it is clamped to the limit and `at_limit` is set. The same happens if
/// there is no such arc (|s| > 1). Because of the clamp, even a film that has no Laplace-Young arc
/// exerts finite forces. These forces move the foam away from states in which a film has no such
/// arc. The gradient is continuous at the limit, because the energy of a Laplace-Young arc is
/// stationary in the half angle. A foam that has a film at the limit does not count as being in
/// equilibrium.
struct FilmEnergy {
    double half_angle = 0.0;  // radians, clamped to the limit
    double value = 0.0;
    // Area between the film and its chord (segment_area in film_arc.h). It equals minus the
    // derivative of `value` with respect to the pressure difference.
    double segment_area = 0.0;
    Vec2 gradient{0.0, 0.0};  // derivative of `value` with respect to the chord
    bool at_limit = false;
};

/// Second derivatives of FilmEnergy::value with respect to the chord and the pressure difference.
struct FilmEnergyHessian {
    Mat2 chord_chord = Mat2::Zero();
    Vec2 chord_pressure{0.0, 0.0};
    double pressure_pressure = 0.0;
};

/// The sine of 80 degrees, the limit of the half angle of an inner film. The limit is well above 60
/// degrees, the half angle of both films of a two-sided bubble on a straight film. It is well below
/// 90 degrees, where the derivatives diverge.
inline constexpr double kLargestSine = 0.984807753012208;

/// Returns the half angle of the Laplace-Young arc (E1) in radians, clamped to the limit
/// (kLargestSine). `pressure_difference` is the pressure on the left minus the pressure on the
/// right. Precondition: the tension T = 2 gamma is positive.
double laplace_young_half_angle(double chord_length, double pressure_difference, double tension);

/// Returns the energy and its first derivatives, which are all zero if the chord is zero.
/// Precondition: the tension is positive.
FilmEnergy film_energy(const Vec2& chord, double pressure_difference, double tension);

/// Returns the second derivatives of the energy, which are all zero if the chord is zero.
/// Precondition: the tension is positive.
FilmEnergyHessian film_energy_hessian(const Vec2& chord,
                                      double pressure_difference,
                                      double tension);

}  // namespace foam
