// SPDX-License-Identifier: Apache-2.0

#include "core/foam/measure.h"

#include "core/geometry/bulge_energy.h"
#include "core/geometry/elementary.h"
#include "core/geometry/film_energy.h"
#include "core/geometry/max_or_nan.h"

#include <array>
#include <cmath>
#include <numbers>

namespace foam {

namespace {

// Returns the largest difference, in radians, between 120 degrees and an angle between two films at
// the junction. Returns pi if a film at the junction has a chord of zero.
double largest_angle_error(const Foam& foam, JunctionId junction) {
    const std::array<HalfEdgeId, 3> leaving = foam.network.leaving(junction);
    std::array<Vec2, 3> tangents;
    for (std::size_t k = 0; k < 3; ++k) {
        const FilmArc arc = film_arc(foam, leaving[k]);
        if (arc.chord == Vec2::Zero()) {
            return std::numbers::pi;
        }
        tangents[k] = tangent_at_tail(arc);
    }
    double largest = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
        // The clockwise angle from a to b, in (-pi, pi]. It is negative if b points to the left of
        // a, as at a junction where bubbles are inverted.
        const Vec2& a = tangents[k];
        const Vec2& b = tangents[(k + 1) % 3];
        const double angle = ieee::atan2(cross(b, a), a.dot(b));
        largest = max_or_nan(largest, std::abs(angle - 2.0 * std::numbers::pi / 3.0));
    }
    return largest;
}

// Returns true if h is a side of an inner film whose half angle is clamped to the limit.
bool is_at_limit(const Foam& foam, HalfEdgeId h) {
    if (foam.network.is_outer(film_of(h))) {
        return false;
    }
    const double s = 0.5 * pressure_difference(foam, h) * chord(foam, h).norm() / foam.film_tension;
    return std::abs(s) > kLargestSine;
}

}  // namespace

double polygon_area(const Foam& foam, BubbleId bubble) {
    double twice_area = 0.0;
    Vec2 corner = Vec2::Zero();
    const HalfEdgeId first = foam.network.first(bubble);
    HalfEdgeId h = first;
    do {
        const Vec2 d = chord(foam, h);
        twice_area += cross(corner, d);
        corner += d;
        h = foam.network.next(h);
    } while (h != first);
    return 0.5 * twice_area;
}

double bubble_area(const Foam& foam, BubbleId bubble) {
    double area = polygon_area(foam, bubble);
    for (const HalfEdgeId h : foam.network.around(bubble)) {
        area += segment_area(film_arc(foam, h));
    }
    return area;
}

Indexed<BubbleId, double> bubble_areas(const Foam& foam) {
    Indexed<BubbleId, double> areas(foam.network.bubble_slots(), 0.0);
    for (const BubbleId bubble : foam.network.bubbles()) {
        areas[bubble] = bubble_area(foam, bubble);
    }
    return areas;
}

void center_pressures(Foam& foam) {
    if (foam.network.ghost() != kNone<BubbleId>) {
        return;
    }
    double weighted = 0.0;
    double total = 0.0;
    for (const BubbleId bubble : foam.network.bubbles()) {
        weighted += foam.target_areas[bubble] * foam.pressures[bubble];
        total += foam.target_areas[bubble];
    }
    for (const BubbleId bubble : foam.network.bubbles()) {
        foam.pressures[bubble] -= weighted / total;
    }
}

double lone_radius(const LoneBubble& bubble) {
    return std::sqrt(bubble.target_area / std::numbers::pi);
}

double lone_pressure(const LoneBubble& bubble, double film_tension) {
    return film_tension / lone_radius(bubble);
}

double energy(const Foam& foam) {
    double length = 0.0;
    for (const FilmId film : foam.network.films()) {
        length += arc_length(film_arc(foam, forward_side(film)));
    }
    for (const LoneBubble& bubble : foam.lone_bubbles) {
        length += 2.0 * std::numbers::pi * lone_radius(bubble);
    }
    return foam.film_tension * length;
}

int films_at_limit(const Foam& foam) {
    int count = 0;
    for (const FilmId film : foam.network.films()) {
        count += is_at_limit(foam, forward_side(film)) ? 1 : 0;
    }
    return count;
}

EquilibriumErrors equilibrium_errors(const Foam& foam) {
    EquilibriumErrors errors;
    for (const BubbleId bubble : foam.network.bubbles()) {
        const double relative = bubble_area(foam, bubble) / foam.target_areas[bubble] - 1.0;
        errors.area = max_or_nan(errors.area, std::abs(relative));
    }
    for (const JunctionId junction : foam.network.junctions()) {
        errors.angle = max_or_nan(errors.angle, largest_angle_error(foam, junction));
    }
    for (const FilmId film : foam.network.films()) {
        if (foam.network.is_outer(film)) {
            const HalfEdgeId h = forward_side(film);
            errors.arc = max_or_nan(
                errors.arc,
                std::abs(laplace_young_error(
                    film_arc(foam, h), pressure_difference(foam, h), foam.film_tension)));
        }
    }
    errors.films_at_limit = films_at_limit(foam);
    return errors;
}

}  // namespace foam
