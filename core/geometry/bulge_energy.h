// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/geometry/film_arc.h"

namespace foam {

/// The contribution of an outer film of a patch to the function L of E3 in core/EQUATIONS.md:
///     energy(d, alpha, delta) = T length - delta segment_area
/// Equilibrium is a stationary point of L. T is the film tension, d the chord, c its length, and
/// delta = p_left - p_right the pressure difference. The half angle alpha in (-pi, pi) is an
/// unknown of its own. Length and segment area are given by E1. The energy is stationary in alpha
/// if Laplace-Young's law holds:
///     d energy / d alpha = c w (T sin alpha - delta c / 2) = 0,  with w as in E3.
/// This formulation is regular at 90 degrees and beyond, where Laplace-Young's law alone does not
/// determine alpha.
struct BulgeEnergy {
    double value = 0.0;
    // Area between the film and its chord (segment_area in film_arc.h). It equals minus the
    // derivative of `value` with respect to the pressure difference.
    double segment_area = 0.0;
    Vec2 gradient{0.0, 0.0};        // derivative of `value` with respect to the chord
    double angle_derivative = 0.0;  // derivative of `value` with respect to the half angle
};

/// Second derivatives of BulgeEnergy::value with respect to the chord, the half angle and the
/// pressure difference. The second derivative with respect to the pressure difference alone is 0.
struct BulgeEnergyHessian {
    Mat2 chord_chord = Mat2::Zero();
    Vec2 chord_pressure{0.0, 0.0};
    Vec2 chord_angle{0.0, 0.0};
    double pressure_angle = 0.0;
    double angle_angle = 0.0;
};

/// Returns the energy and its first derivatives, which are all zero if the chord is zero.
/// `pressure_difference` is the pressure on the left minus the pressure on the right. Precondition:
/// the tension T is positive.
BulgeEnergy bulge_energy(const FilmArc& arc, double pressure_difference, double tension);

/// Returns the second derivatives of the energy, which are all zero if the chord is zero.
/// Precondition: the tension T is positive.
BulgeEnergyHessian bulge_energy_hessian(const FilmArc& arc,
                                        double pressure_difference,
                                        double tension);

/// Returns sin alpha - delta c / 2T, which is zero if Laplace-Young's law holds. Precondition: the
/// tension T is positive.
double laplace_young_error(const FilmArc& arc, double pressure_difference, double tension);

}  // namespace foam
