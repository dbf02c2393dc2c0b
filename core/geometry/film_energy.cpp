// SPDX-License-Identifier: Apache-2.0

#include "core/geometry/film_energy.h"

#include "core/geometry/elementary.h"

#include <algorithm>
#include <cmath>

// The derivatives are given by E3 in core/EQUATIONS.md. The energy of a Laplace-Young arc is
// stationary in the half angle, so the gradient of the energy is its partial derivative at a fixed
// half angle. At the limit (kLargestSine) the half angle is constant, so the second derivatives are
// taken at a fixed half angle, too.

namespace foam {

namespace {

struct FilmState {
    double chord_length;
    double s;  // sine of the half angle, clamped to the limit
    bool at_limit;
};

FilmState film_state(double chord_length, double pressure_difference, double tension) {
    const double s = 0.5 * pressure_difference * chord_length / tension;
    const double limited = std::clamp(s, -kLargestSine, kLargestSine);
    return {chord_length, limited, limited != s};
}

// Returns the derivative of the energy with respect to the chord length at a fixed half angle. This
// is the pull of the film along its chord. On a Laplace-Young arc this is T cos(alpha).
double pull_along_chord(const FilmState& state, double pressure_difference, double tension) {
    if (!state.at_limit) {
        return tension * std::sqrt((1.0 - state.s) * (1.0 + state.s));
    }
    return tension * ieee::asin(state.s) / state.s -
           0.5 * pressure_difference * state.chord_length * segment_shape(state.s);
}

}  // namespace

double laplace_young_half_angle(double chord_length, double pressure_difference, double tension) {
    return ieee::asin(film_state(chord_length, pressure_difference, tension).s);
}

FilmEnergy film_energy(const Vec2& chord, double pressure_difference, double tension) {
    const double c = chord.norm();
    if (c == 0.0) {
        return {};
    }
    const FilmState state = film_state(c, pressure_difference, tension);
    FilmEnergy energy;
    energy.half_angle = ieee::asin(state.s);
    energy.segment_area = 0.25 * c * c * segment_shape(state.s);
    const double length = state.s == 0.0 ? c : c * energy.half_angle / state.s;
    energy.value = tension * length - pressure_difference * energy.segment_area;
    energy.gradient = pull_along_chord(state, pressure_difference, tension) / c * chord;
    energy.at_limit = state.at_limit;
    return energy;
}

FilmEnergyHessian film_energy_hessian(const Vec2& chord,
                                      double pressure_difference,
                                      double tension) {
    const double c = chord.norm();
    if (c == 0.0) {
        return {};
    }
    const FilmState state = film_state(c, pressure_difference, tension);
    const Vec2 u = chord / c;
    const Vec2 n = turned_left(u);
    const double pull = pull_along_chord(state, pressure_difference, tension);
    FilmEnergyHessian hessian;
    double along_chord = 0.0;
    if (state.at_limit) {
        const double shape = segment_shape(state.s);
        along_chord = -0.5 * pressure_difference * shape;
        hessian.chord_pressure = -0.5 * c * shape * u;
    } else {
        const double tangent = state.s / std::sqrt((1.0 - state.s) * (1.0 + state.s));
        along_chord = -0.5 * pressure_difference * tangent;
        hessian.chord_pressure = -0.5 * c * tangent * u;
        hessian.pressure_pressure =
            -c * c * c / (8.0 * tension) * segment_shape_derivative(state.s);
    }
    hessian.chord_chord = along_chord * u * u.transpose() + pull / c * n * n.transpose();
    return hessian;
}

}  // namespace foam
