// SPDX-License-Identifier: Apache-2.0

#include "core/geometry/bulge_energy.h"

#include "core/geometry/elementary.h"

// The energy of an outer film is T c q(alpha) - delta c² h(alpha) / 4. Here T is the film tension,
// c the length of the chord, delta the pressure difference and alpha the half angle. The functions
// q, h and w are defined in ArcShape. The energy is differentiated with respect to the chord, the
// pressure difference and the half angle (E3 in core/EQUATIONS.md). The derivatives follow from
// q' = sin(alpha) w and h' = 2 w.

namespace foam {

namespace {

// Returns the derivative of the energy with respect to the chord length. This is the pull of the
// film along its chord.
double pull_along_chord(double chord_length,
                        const ArcShape& shape,
                        double pressure_difference,
                        double tension) {
    return tension * shape.length - 0.5 * pressure_difference * chord_length * shape.segment;
}

}  // namespace

BulgeEnergy bulge_energy(const FilmArc& arc, double pressure_difference, double tension) {
    const double c = arc.chord.norm();
    if (c == 0.0) {
        return {};
    }
    const ArcShape shape = arc_shape(arc.half_angle);
    BulgeEnergy energy;
    energy.segment_area = 0.25 * c * c * shape.segment;
    energy.value = tension * c * shape.length - pressure_difference * energy.segment_area;
    energy.gradient = pull_along_chord(c, shape, pressure_difference, tension) / c * arc.chord;
    energy.angle_derivative =
        c * shape.bulging * tension * laplace_young_error(arc, pressure_difference, tension);
    return energy;
}

BulgeEnergyHessian bulge_energy_hessian(const FilmArc& arc,
                                        double pressure_difference,
                                        double tension) {
    const double c = arc.chord.norm();
    if (c == 0.0) {
        return {};
    }
    const ArcShape shape = arc_shape(arc.half_angle);
    const Vec2 u = arc.chord / c;
    const Vec2 n = turned_left(u);
    const auto [sine, cosine] = ieee::sincos(arc.half_angle);
    const double error = sine - 0.5 * pressure_difference * c / tension;
    BulgeEnergyHessian hessian;
    hessian.chord_chord =
        -0.5 * pressure_difference * shape.segment * u * u.transpose() +
        pull_along_chord(c, shape, pressure_difference, tension) / c * n * n.transpose();
    hessian.chord_pressure = -0.5 * c * shape.segment * u;
    hessian.chord_angle = shape.bulging * (tension * sine - pressure_difference * c) * u;
    hessian.pressure_angle = -0.5 * c * c * shape.bulging;
    hessian.angle_angle = tension * c * (shape.bulging_derivative * error + shape.bulging * cosine);
    return hessian;
}

double laplace_young_error(const FilmArc& arc, double pressure_difference, double tension) {
    return ieee::sin(arc.half_angle) - 0.5 * pressure_difference * arc.chord.norm() / tension;
}

}  // namespace foam
