// SPDX-License-Identifier: Apache-2.0

#include "core/foam/foam.h"

#include "core/geometry/film_energy.h"

#include <algorithm>
#include <limits>
#include <numbers>
#include <utility>

namespace foam {

namespace {

// Largest half angle of an outer film, in radians. The chord of such an arc is 1e-6 of the diameter
// of its circle. No film of a bubble above the T2 area is so close to a full circle.
constexpr double kMaxHalfAngle = std::numbers::pi - 1e-6;

// Puts the values into the order of `ids`, and removes the values of all other ids.
template <class Id, class T>
void reorder(Indexed<Id, T>& values, const std::vector<Id>& ids) {
    Indexed<Id, T> reordered;
    for (const Id id : ids) {
        reordered.push_back(values[id]);
    }
    values = std::move(reordered);
}

}  // namespace

Vec2 chord(const Foam& foam, HalfEdgeId h) {
    const Network& network = foam.network;
    return foam.positions[network.head(h)] + foam.domain.translation(network.offset(h)) -
           foam.positions[network.tail(h)];
}

Vec2 middle_of(const Foam& foam, FilmId film) {
    const HalfEdgeId h = forward_side(film);
    return foam.positions[foam.network.tail(h)] + 0.5 * chord(foam, h);
}

double pressure_difference(const Foam& foam, HalfEdgeId h) {
    return foam.pressures[foam.network.left(h)] - foam.pressures[foam.network.right(h)];
}

FilmArc film_arc(const Foam& foam, HalfEdgeId h) {
    const Vec2 d = chord(foam, h);
    const FilmId film = film_of(h);
    if (foam.network.is_outer(film)) {
        return {d, is_forward(h) ? foam.half_angles[film] : -foam.half_angles[film]};
    }
    return {d, laplace_young_half_angle(d.norm(), pressure_difference(foam, h), foam.film_tension)};
}

void set_half_angle(Foam& foam, HalfEdgeId h, double angle) {
    const double clamped = std::clamp(angle, -kMaxHalfAngle, kMaxHalfAngle);
    foam.half_angles[film_of(h)] = is_forward(h) ? clamped : -clamped;
}

void fit_half_angle(Foam& foam, FilmId film) {
    if (foam.network.is_outer(film)) {
        const HalfEdgeId h = forward_side(film);
        foam.half_angles[film] = laplace_young_half_angle(
            chord(foam, h).norm(), pressure_difference(foam, h), foam.film_tension);
    }
}

void complete_patch(Foam& foam) {
    foam.domain = kPlane;
    foam.pressures.push_back(0.0);
    foam.target_areas.push_back(std::numeric_limits<double>::infinity());
    foam.identities.push_back(kNoIndex);
    foam.half_angles.resize(foam.network.film_slots(), 0.0);
    for (const FilmId film : foam.network.films()) {
        fit_half_angle(foam, film);
    }
}

void place_junction(Foam& foam, JunctionId junction, const Vec2& point) {
    const LatticeOffset cell = foam.domain.cell_of(point);
    foam.positions[junction] = point - foam.domain.translation(cell);
    if (cell != LatticeOffset{}) {
        foam.network.rebase(junction, cell);
    }
}

void translate(Foam& foam, const Vec2& displacement) {
    for (const JunctionId junction : foam.network.junctions()) {
        place_junction(foam, junction, foam.positions[junction] + displacement);
    }
}

void renumber(Foam& foam, const Network::OldIds& order) {
    foam.network.renumber(order);
    reorder(foam.positions, order.junctions);
    reorder(foam.pressures, order.bubbles);
    reorder(foam.target_areas, order.bubbles);
    reorder(foam.identities, order.bubbles);
    reorder(foam.t1_armed, order.films);
    if (foam.network.ghost() != kNone<BubbleId>) {
        reorder(foam.half_angles, order.films);
    }
}

void compact(Foam& foam) {
    if (!foam.network.is_compact()) {
        renumber(foam, foam.network.live_ids());
    }
}

}  // namespace foam
