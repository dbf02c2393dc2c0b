// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/geometry/film_arc.h"

namespace foam {

/// The contribution of a film with a free half angle to the function whose stationary point is
/// equilibrium (E3): energy(d, alpha, delta) = T length - delta segment_area. Length and area are
/// those of E1 for any half angle in (-pi, pi); delta = p_left - p_right is the pressure
/// difference. The energy is stationary in alpha if Laplace-Young's law holds:
///     energy_alpha = c w (T sin alpha - delta c / 2) = 0,  with w as in ArcShape.
/// This formulation is regular at 90 degrees and beyond, where the law alone does not determine
/// alpha.
struct BulgeEnergy {
    double value = 0.0;
    double segment_area = 0.0;  // minus the derivative by the pressure difference
    Vec2 gradient{0.0, 0.0};    // derivative by the chord
    double by_angle = 0.0;      // derivative by the half angle
};

/// Second derivatives of BulgeEnergy::value. The second derivative by the pressure difference is 0.
struct BulgeEnergyHessian {
    Mat2 chord_chord = Mat2::Zero();
    Vec2 chord_pressure{0.0, 0.0};
    Vec2 chord_angle{0.0, 0.0};
    double pressure_angle = 0.0;
    double angle_angle = 0.0;
};

/// Returns the energy and its first derivatives, all zero if the chord is zero. Precondition: the
/// tension T is positive.
BulgeEnergy bulge_energy(const FilmArc& arc, double pressure_difference, double tension);

/// Returns the second derivatives of the energy, all zero if the chord is zero. Precondition: the
/// tension T is positive.
BulgeEnergyHessian bulge_energy_hessian(const FilmArc& arc,
                                        double pressure_difference,
                                        double tension);

/// Returns sin alpha - delta c / 2T, which is zero if Laplace-Young's law holds.
double laplace_young_error(const FilmArc& arc, double pressure_difference, double tension);

}  // namespace foam
