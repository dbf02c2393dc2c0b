// SPDX-License-Identifier: Apache-2.0

#include "core/dynamics/nucleation.h"

#include "core/foam/record_event.h"
#include "core/network/insertion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>
#include <vector>

// Nucleation (E10) is the inverse of the T2 process. The new bubble gets the shape and the pressure
// that it would have in equilibrium if the films at its corners were straight. Newton's method
// therefore starts near the solution.
//
// Let g be segment_shape (E3). A regular three-sided bubble has three arcs with a half angle of 30
// degrees on an equilateral triangle of side c. Its area is c² (sqrt(3)/4 + 3 g(1/2)/4). The radius
// of its arcs is c, and its corners are at c / sqrt(3) from its center. A regular lens has two arcs
// with a half angle of 60 degrees on a chord c. Its area is c² g(sqrt(3)/2) / 2, and the radius of
// its arcs is c / sqrt(3).

namespace foam {

namespace {

// Largest fraction of the gas of the surrounding bubbles that a new bubble may take.
constexpr double kMaxGasFraction = 0.5;
// Before the equilibration, a new bubble at a junction covers at most this fraction of the length
// of each film at the junction. A new bubble on a film extends from the middle of the film by at
// most this fraction of the whole length in each direction.
constexpr double kMaxFilmFraction = 0.45;

// Returns the side of the triangle of a regular three-sided bubble of the given area.
double triangle_side(double area) {
    return std::sqrt(area / (0.25 * std::numbers::sqrt3 + 0.75 * segment_shape(0.5)));
}

// Returns the chord of a regular two-sided bubble of the given area.
double lens_chord(double area) {
    return std::sqrt(area / (0.5 * segment_shape(0.5 * std::numbers::sqrt3)));
}

// Takes the area from the bubbles in proportion to their target areas. Returns false and changes
// nothing if their target areas are too small. If the ghost is one of the bubbles, all the gas
// comes from the ghost, because its target area is infinite.
bool take_gas(Foam& foam, const std::set<BubbleId>& bubbles, double area) {
    double sum = 0.0;
    for (const BubbleId bubble : bubbles) {
        sum += foam.target_areas[bubble];
    }
    if (area > kMaxGasFraction * sum) {
        return false;
    }
    for (const BubbleId bubble : bubbles) {
        foam.target_areas[bubble] *= std::isinf(sum) ? 1.0 : (sum - area) / sum;
    }
    return true;
}

double mean_pressure(const Foam& foam, const std::set<BubbleId>& bubbles) {
    double sum = 0.0;
    for (const BubbleId bubble : bubbles) {
        sum += foam.pressures[bubble];
    }
    return sum / static_cast<double>(bubbles.size());
}

// Appends values for the new junctions, films and bubble of the network to the vectors of the foam,
// such as positions and pressures. The new junctions are at the origin until the caller places
// them.
void complete(Foam& foam, double area, double pressure, BubbleIdentity identity) {
    foam.positions.resize(foam.network.junction_slots(), Vec2(0.0, 0.0));
    foam.t1_armed.resize(foam.network.film_slots(), 1);
    foam.pressures.push_back(pressure);
    foam.target_areas.push_back(area);
    foam.identities.push_back(identity);
    if (foam.network.ghost() != kNone<BubbleId>) {
        foam.half_angles.resize(foam.network.film_slots(), 0.0);
    }
}

// Returns the distance as a fraction of the length of the arc, at most kMaxFilmFraction.
double fraction_of(const FilmArc& arc, double distance) {
    return std::min(distance / arc_length(arc), kMaxFilmFraction);
}

// Sets the half angle of an outer film of which a new bubble has cut off a part. `whole_half_angle`
// is the half angle of the whole arc along h; `remaining` is the fraction of the arc's length that
// remains. Does nothing to inner films, because their half angles follow from the pressures.
void cut_film(Foam& foam, HalfEdgeId h, double whole_half_angle, double remaining) {
    if (foam.network.is_outer(film_of(h))) {
        foam.half_angles[film_of(h)] = (is_forward(h) ? 1.0 : -1.0) * remaining * whole_half_angle;
    }
}

// Records the birth of a bubble. The event lists the bubble and the bubbles around it.
void record_birth(Foam& foam,
                  BubbleId bubble,
                  const Vec2& position,
                  const std::set<BubbleId>& around) {
    std::vector<BubbleId> bubbles{bubble};
    bubbles.insert(bubbles.end(), around.begin(), around.end());
    record_event(foam, TopologyEventKind::Birth, position, bubbles);
}

void fit_films_around(Foam& foam, BubbleId bubble) {
    for (const HalfEdgeId h : foam.network.around(bubble)) {
        fit_half_angle(foam, film_of(h));
    }
}

}  // namespace

std::optional<BubbleId> nucleate_at_junction(Foam& foam,
                                             JunctionId junction,
                                             double area,
                                             std::optional<BubbleIdentity> identity) {
    std::set<BubbleId> around;
    std::array<Vec2, 3> corners;
    std::array<FilmArc, 3> arcs;
    std::array<double, 3> cut_fractions{};
    const double side = triangle_side(area);
    const auto [a, b, c] = foam.network.leaving(junction);
    const std::array<HalfEdgeId, 3> spokes{a, c, b};  // counter-clockwise
    for (std::size_t k = 0; k < 3; ++k) {
        around.insert(foam.network.left(spokes[k]));
        arcs[k] = film_arc(foam, spokes[k]);
        cut_fractions[k] = fraction_of(arcs[k], side / std::numbers::sqrt3);
        corners[k] = foam.positions[junction] + point_at(arcs[k], cut_fractions[k]);
    }
    if (!take_gas(foam, around, area)) {
        return std::nullopt;
    }
    const double pressure = mean_pressure(foam, around) + foam.film_tension / side;
    const Vec2 middle = foam.positions[junction];
    const BubbleId bubble = insert_triangle(foam.network, junction);
    complete(foam, area, pressure, identity ? *identity : foam.next_identity++);
    record_birth(foam, bubble, middle, around);
    const std::vector<HalfEdgeId> loop = foam.network.around(bubble);
    for (std::size_t k = 0; k < 3; ++k) {
        place_junction(foam, foam.network.tail(loop[k]), corners[k]);
        cut_film(foam, spokes[k], arcs[k].half_angle, 1.0 - cut_fractions[k]);
    }
    fit_films_around(foam, bubble);
    return bubble;
}

std::optional<BubbleId> nucleate_on_film(Foam& foam, FilmId film, double area) {
    const HalfEdgeId h = forward_side(film);
    const std::set<BubbleId> beside{foam.network.left(h), foam.network.right(h)};
    if (!take_gas(foam, beside, area)) {
        return std::nullopt;
    }
    const FilmArc arc = film_arc(foam, h);
    const double chord_length = lens_chord(area);
    const double half_fraction = std::min(0.5 * chord_length / arc_length(arc), kMaxFilmFraction);
    const Vec2 tail = foam.positions[foam.network.tail(h)];
    const double pressure =
        mean_pressure(foam, beside) + std::numbers::sqrt3 * foam.film_tension / chord_length;
    const BubbleId bubble = insert_lens(foam.network, h);
    complete(foam, area, pressure, foam.next_identity++);
    record_birth(foam, bubble, tail + point_at(arc, 0.5), beside);
    const HalfEdgeId first = foam.network.first(bubble);
    place_junction(foam, foam.network.head(first), tail + point_at(arc, 0.5 - half_fraction));
    place_junction(foam, foam.network.tail(first), tail + point_at(arc, 0.5 + half_fraction));
    cut_film(foam, h, arc.half_angle, 0.5 - half_fraction);
    cut_film(foam, foam.network.previous(twin(first)), arc.half_angle, 0.5 - half_fraction);
    fit_films_around(foam, bubble);
    return bubble;
}

}  // namespace foam
