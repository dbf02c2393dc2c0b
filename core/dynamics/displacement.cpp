// SPDX-License-Identifier: Apache-2.0

#include "core/dynamics/displacement.h"

#include "core/foam/t1_rule.h"

#include <algorithm>
#include <cmath>

namespace foam {

namespace {

// Largest step of a push (E9 in core/EQUATIONS.md), in units of the radius R of the push. The slope
// of (1 - u²)² with u = r/R is at most 1.54. A step of less than 0.64 radii therefore does not fold
// the plane: points keep their order along the push. The step is much smaller because films flip
// only between steps.
constexpr double kMaxStep = 0.1;
// The T1 distance during a push, unless the given distance is larger. This value is the upper end
// of the range that the paper recommends (eq. 16). With the default of TopologyThresholds, 0.05,
// hardly any film would flip.
constexpr double kT1Distance = 0.25;
// A film may flip during a push if it is shorter than this fraction of its reference length. The
// reference length is the length at the start of the push or, if the film has flipped, after its
// last flip.
constexpr double kShortened = 0.5;

// Returns the length of the chord.
double length_of(const Foam& foam, FilmId film) {
    return chord(foam, forward_side(film)).norm();
}

void move_junctions(Foam& foam, const Displacement& step) {
    for (const JunctionId junction : foam.network.junctions()) {
        const Vec2 position = foam.positions[junction];
        const double u = foam.domain.nearest_copy(position - step.center).norm() / step.radius;
        if (u < 1.0) {
            const double weight = (1.0 - u * u) * (1.0 - u * u);
            place_junction(foam, junction, position + weight * step.by);
        }
    }
}

// Applies the T1 rule to the short films that have lost more than half of their length. `lengths`
// has the reference length of each film: the length at the start of the push or, if the film has
// flipped, after its last flip. The entries of removed films are unused. Returns the number of T1s.
int flip_shortened(Foam& foam, TopologyThresholds thresholds, Indexed<FilmId, double>& lengths) {
    thresholds.t1_distance = std::max(thresholds.t1_distance, kT1Distance);
    int flips = 0;
    for (const FilmId film : short_films(foam, thresholds)) {
        // An earlier change may have removed the film: in a patch, films tear and holes close.
        if (foam.network.is_live(film) && length_of(foam, film) < kShortened * lengths[film] &&
            apply_t1_rule(foam, film, thresholds)) {
            lengths[film] = foam.network.is_live(film) ? length_of(foam, film) : 0.0;
            ++flips;
        }
    }
    return flips;
}

}  // namespace

int displace(Foam& foam, const Displacement& displacement, const TopologyThresholds& thresholds) {
    const double ratio = displacement.by.norm() / (kMaxStep * displacement.radius);
    const int steps = std::max(1, static_cast<int>(std::ceil(ratio)));
    Displacement step = displacement;
    step.by /= steps;
    Indexed<FilmId, double> lengths(foam.network.film_slots(), 0.0);
    for (const FilmId film : foam.network.films()) {
        lengths[film] = length_of(foam, film);
    }
    int flips = 0;
    for (int k = 0; k < steps; ++k) {
        move_junctions(foam, step);
        flips += flip_shortened(foam, thresholds, lengths);
        step.center += step.by;
    }
    return flips;
}

}  // namespace foam
