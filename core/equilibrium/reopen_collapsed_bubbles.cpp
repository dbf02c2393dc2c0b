// SPDX-License-Identifier: Apache-2.0

#include "core/equilibrium/reopen_collapsed_bubbles.h"

#include "core/foam/measure.h"
#include "core/geometry/film_arc.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace foam {

namespace {

// A two-sided bubble is collapsed if its area is less than this fraction of its target area.
constexpr double kCollapsedAreaFraction = 0.01;
// Largest move of an end of a bubble, in chord lengths of the third film at this end.
constexpr double kMaxMove = 1.0 / 3.0;

// Returns the half-edge that leaves the tail of h along the film that does not belong to the
// two-sided bubble on the left of h.
HalfEdgeId third_film(const Network& network, HalfEdgeId h) {
    HalfEdgeId third = kNone<HalfEdgeId>;
    for (const HalfEdgeId leaving : network.leaving(network.tail(h))) {
        if (film_of(leaving) != film_of(h) && film_of(leaving) != film_of(network.next(h))) {
            third = leaving;
        }
    }
    return third;
}

// Returns true if the bubble is collapsed, has no outer film, and has different third films
// (third_film) at its two ends.
bool needs_reopening(const Foam& foam, BubbleId bubble) {
    const Network& network = foam.network;
    if (network.sides(bubble) != 2 ||
        bubble_area(foam, bubble) >= kCollapsedAreaFraction * foam.target_areas[bubble]) {
        return false;
    }
    const HalfEdgeId h = network.first(bubble);
    return !network.is_outer(film_of(h)) && !network.is_outer(film_of(network.next(h))) &&
           film_of(third_film(network, h)) != film_of(third_film(network, network.next(h)));
}

// Returns the distance between the ends of a two-sided bubble in equilibrium if the pressures on
// its two sides are equal. Each film then has a half angle of 60 degrees and encloses half of the
// area with its chord.
double equilibrium_chord(double area) {
    const double area_of_unit_chord = 2.0 * segment_area({Vec2(1.0, 0.0), std::numbers::pi / 3.0});
    return std::sqrt(area / area_of_unit_chord);
}

void move_along_third_film(Foam& foam, HalfEdgeId h, double largest) {
    const Vec2 ahead = chord(foam, third_film(foam.network, h));
    const double length = ahead.norm();
    if (length > 0.0) {
        const double fraction = std::min(kMaxMove, largest / length);
        const JunctionId end = foam.network.tail(h);
        place_junction(foam, end, foam.positions[end] + fraction * ahead);
    }
}

void reopen(Foam& foam, BubbleId bubble) {
    const HalfEdgeId h = foam.network.first(bubble);
    const HalfEdgeId back = foam.network.next(h);
    const double largest = 0.5 * equilibrium_chord(foam.target_areas[bubble]);
    move_along_third_film(foam, h, largest);
    move_along_third_film(foam, back, largest);
    const double pressure_around = 0.5 * (foam.pressures[foam.network.left(twin(h))] +
                                          foam.pressures[foam.network.left(twin(back))]);
    const double length = chord(foam, h).norm();
    if (length > 0.0) {
        foam.pressures[bubble] = pressure_around + std::numbers::sqrt3 * foam.film_tension / length;
    }
}

}  // namespace

int reopen_collapsed_bubbles(Foam& foam) {
    int reopened = 0;
    for (const BubbleId bubble : foam.network.bubbles()) {
        if (needs_reopening(foam, bubble)) {
            reopen(foam, bubble);
            ++reopened;
        }
    }
    return reopened;
}

}  // namespace foam
