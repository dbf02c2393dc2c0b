#pragma once

#include "core/geometry/film_arc.h"

namespace foam {

/// What a film whose half angle is free adds to the function whose stationary point is equilibrium
/// (E3): energy(d, alpha, delta) = T length - delta segment_area, with the length and the area of
/// E1 for any half angle in (-pi, pi) and the pressure difference delta = p_left - p_right. Being
/// stationary in alpha is Laplace-Young's law,
///     energy_alpha = c w (T sin alpha - delta c / 2) = 0  (w as in ArcShape),
/// and is regular at 90 degrees and beyond, where that law alone does not tell alpha.
struct BulgeEnergy {
    double value = 0.0;
    double segment_area = 0.0;  // minus the derivative by the pressure difference
    Vec2 gradient{0.0, 0.0};    // by the chord
    double by_angle = 0.0;
};

/// Second derivatives of BulgeEnergy::value; that by the pressure difference alone is 0.
struct BulgeEnergyHessian {
    Mat2 chord_chord = Mat2::Zero();
    Vec2 chord_pressure{0.0, 0.0};
    Vec2 chord_angle{0.0, 0.0};
    double pressure_angle = 0.0;
    double angle_angle = 0.0;
};

/// A zero chord gives zeros. Tension T > 0.
BulgeEnergy bulge_energy(const FilmArc& arc, double pressure_difference, double tension);

BulgeEnergyHessian bulge_energy_hessian(const FilmArc& arc,
                                        double pressure_difference,
                                        double tension);

/// sin alpha - delta c / 2T: zero where Laplace-Young's law holds.
double laplace_young_error(const FilmArc& arc, double pressure_difference, double tension);

}  // namespace foam
