#pragma once

#include "core/geometry/film_arc.h"

namespace foam {

/// What one film adds to the function whose stationary point is equilibrium (E3):
/// energy(d, delta) = T length - delta segment_area, the arc being the Laplace-Young arc of the
/// chord d under the pressure difference delta = p_left - p_right.
///
/// Where the Laplace-Young arc would turn by more than the largest half angle, or has no solution
/// (|s| >= 1), the half angle stays at that limit. The gradient is still continuous there, because
/// an arc is stationary in its half angle at the switch, so that a state that is locally
/// ill-defined has finite forces that lead out of it. `at_limit` tells; no equilibrium may rest on
/// such a film.
struct FilmEnergy {
    double half_angle = 0.0;
    double value = 0.0;
    double segment_area = 0.0;  // minus the derivative by the pressure difference
    Vec2 gradient{0.0, 0.0};    // by the chord
    bool at_limit = false;
};

/// Second derivatives of FilmEnergy::value.
struct FilmEnergyHessian {
    Mat2 chord_chord = Mat2::Zero();
    Vec2 chord_pressure{0.0, 0.0};
    double pressure_pressure = 0.0;
};

/// sin of the largest half angle of a film inside a foam, 80 degrees: well above the 60 degrees of
/// a two-sided bubble on a straight film, and well below 90, where the derivatives blow up.
inline constexpr double kLargestSine = 0.984807753012208;

/// The half angle of the Laplace-Young arc, held at the limit. Tension T = 2 gamma > 0.
double laplace_young_half_angle(double chord_length, double pressure_difference, double tension);

/// A zero chord gives zeros.
FilmEnergy film_energy(const Vec2& chord, double pressure_difference, double tension);

FilmEnergyHessian film_energy_hessian(const Vec2& chord,
                                      double pressure_difference,
                                      double tension);

}  // namespace foam
