// SPDX-License-Identifier: Apache-2.0

#include "core/foam/t1_rule.h"

#include "core/foam/rafts.h"
#include "core/foam/record_event.h"
#include "core/network/split.h"
#include "core/network/t1.h"

#include <algorithm>
#include <cmath>

// The paper flips every film below the T1 distance (paper eq. 2). This rule adds a test of forces,
// so that a flip does not have to be undone (E7 in core/EQUATIONS.md). Forces are in units of the
// film tension. The flipped film pulls the junctions at its ends together with a force of 1, and
// the neighboring films pull them apart. The flipped film stays open if the neighboring films pull
// harder. The same forces decide whether a collapsed film is flipped before it is reopened.

namespace foam {

namespace {

// A film that has flipped is disarmed (Foam::t1_armed): its T1 distance is shorter until the film
// has grown, so that films do not flip to and fro. The following lengths are in units of the T1
// distance at the film (scaled_distance).
constexpr double kDisarmedFraction = 0.1;    // a disarmed film may flip again below this length
constexpr double kCollapsedFraction = 0.05;  // a film counts as collapsed below this length
constexpr double kRearmingFactor = 2.0;      // a disarmed film is armed again above this length
// Length of a reopened film, in units of the length below which a film counts as collapsed.
constexpr double kReopenedLength = 2.0;

// Returns the T1 distance at the film without regard to whether the film is armed. It is scaled
// down if the smallest target area of the four bubbles around the film is below 1.
double scaled_distance(const Foam& foam, FilmId film, const TopologyThresholds& thresholds) {
    const T1Site site = t1_site(foam.network, film);
    const double smallest = std::min({foam.target_areas[foam.network.left(site.film)],
                                      foam.target_areas[foam.network.right(site.film)],
                                      foam.target_areas[site.end_tail],
                                      foam.target_areas[site.end_head]});
    return thresholds.t1_distance * std::min(1.0, std::sqrt(smallest));
}

// Returns the unit tangent of the arc along h at the tail of h, or zero if the chord is zero.
Vec2 tangent(const Foam& foam, HalfEdgeId h) {
    const FilmArc arc = film_arc(foam, h);
    return arc.chord == Vec2::Zero() ? Vec2(0.0, 0.0) : tangent_at_tail(arc);
}

// The pull with which the four neighboring films stretch a film, in units of the film tension. The
// pull is half of the difference between the forces on the two ends of the film. The flipped film
// is across the present film: its left end is on the left of the present film.
struct NeighborPull {
    Vec2 present;  // half of (force on head - force on tail) of the present film
    Vec2 flipped;  // half of (force on left end - force on right end) of the flipped film
};

NeighborPull neighbor_pull(const Foam& foam, FilmId film) {
    const T1Site site = t1_site(foam.network, film);
    const Vec2 tail_left = tangent(foam, twin(site.before_left));
    const Vec2 tail_right = tangent(foam, site.after_right);
    const Vec2 head_left = tangent(foam, site.after_left);
    const Vec2 head_right = tangent(foam, twin(site.before_right));
    return {0.5 * (head_left + head_right - tail_left - tail_right),
            0.5 * (tail_left + head_left - tail_right - head_right)};
}

// Moves the junctions of the film so that its chord has the midpoint `middle` and is the vector
// `tail_to_head`. On a torus, `middle` may be outside of the fundamental cell; place_junction wraps
// both junctions into the cell.
void place_film(Foam& foam, FilmId film, const Vec2& middle, const Vec2& tail_to_head) {
    const HalfEdgeId h = forward_side(film);
    const Vec2 head_translation = foam.domain.translation(foam.network.offset(h));
    const JunctionId tail = foam.network.tail(h);
    const JunctionId head = foam.network.head(h);
    place_junction(foam, tail, middle - 0.5 * tail_to_head);
    place_junction(foam, head, middle + 0.5 * tail_to_head - head_translation);
}

// Returns true if the film is shorter than its T1 distance, can flip or tear, and would stay open
// afterwards. The comparison with the unscaled T1 distance is redundant, but rejects most films at
// little cost.
bool should_flip_or_tear(const Foam& foam, FilmId film, const TopologyThresholds& thresholds) {
    const double length = chord(foam, forward_side(film)).norm();
    return length < thresholds.t1_distance && length < t1_distance_at(foam, film, thresholds) &&
           can_change(foam.network, film) && would_stay_open(foam, film);
}

// Returns true if the neighboring films pull harder across the film than along it. The tension of
// the film itself is subtracted from the pull along it. Precondition: the film can tear.
bool tears_apart(const Foam& foam, FilmId film) {
    const NeighborPull pull = neighbor_pull(foam, film);
    return pull.flipped.norm() > pull.present.norm() - 1.0;
}

// Closes the hole or, if that is not possible, flips the film. Does not compare pulls, because
// where bubbles overlap in a hole, the pulls on short films have the wrong direction. Returns true
// if the network changed.
bool shrink_hole(Foam& foam, FilmId film) {
    if (close_hole(foam, film)) {
        return true;
    }
    const bool flips = can_flip(foam.network, film);
    if (flips) {
        flip_film(foam, film);
    }
    return flips;
}

}  // namespace

double t1_distance_at(const Foam& foam, FilmId film, const TopologyThresholds& thresholds) {
    return scaled_distance(foam, film, thresholds) *
           (foam.t1_armed[film] != 0 ? 1.0 : kDisarmedFraction);
}

double collapsed_length(const Foam& foam, FilmId film, const TopologyThresholds& thresholds) {
    return kCollapsedFraction * scaled_distance(foam, film, thresholds);
}

bool would_stay_open(const Foam& foam, FilmId film) {
    const Vec2 pull = neighbor_pull(foam, film).flipped;
    const Vec2 d = chord(foam, forward_side(film));
    const double apart = d == Vec2::Zero() ? pull.norm() : pull.dot(turned_left(d).normalized());
    return apart > (can_tear(foam.network, film) ? 0.0 : 1.0);
}

void flip_film(Foam& foam, FilmId film) {
    const Vec2 right_to_left = turned_left(chord(foam, forward_side(film)));
    const Vec2 middle = middle_of(foam, film);
    record_t1(foam, film);
    flip(foam.network, film);
    // The flipped film runs from the left of the old film to its right.
    place_film(foam, film, middle, -right_to_left);
    fit_half_angle(foam, film);
    foam.t1_armed[film] = 0;
}

bool reopen_film(Foam& foam, FilmId film, double length) {
    const NeighborPull pull = neighbor_pull(foam, film);
    const Vec2 middle = middle_of(foam, film);
    const bool flips =
        pull.flipped.squaredNorm() > pull.present.squaredNorm() && can_flip(foam.network, film);
    if (flips) {
        record_t1(foam, film);
        flip(foam.network, film);
        foam.t1_armed[film] = 0;
    }
    const Vec2 along = flips ? Vec2(-pull.flipped) : pull.present;
    const Vec2 direction = along == Vec2::Zero() ? Vec2(1.0, 0.0) : Vec2(along.normalized());
    place_film(foam, film, middle, length * direction);
    fit_half_angle(foam, film);
    return flips;
}

bool can_change(const Network& network, FilmId film) {
    return can_flip(network, film) || can_tear(network, film);
}

bool can_tear(const Network& network, FilmId film) {
    const HalfEdgeId h = forward_side(film);
    return can_split(network, film) && network.sides(network.left(h)) > 2 &&
           network.sides(network.right(h)) > 2;
}

bool apply_t1_rule(Foam& foam, FilmId film, const TopologyThresholds& thresholds) {
    const double collapsed = collapsed_length(foam, film, thresholds);
    const double length = chord(foam, forward_side(film)).norm();
    if (can_tear(foam.network, film)) {
        const bool tears = should_flip_or_tear(foam, film, thresholds) ||
                           (length < collapsed && tears_apart(foam, film));
        if (tears) {
            tear_film(foam, film);
        }
        return tears;
    }
    if (foam.network.is_outer(film)) {
        if (is_small_hole(foam, film, thresholds.t1_distance)) {
            return close_hole(foam, film);
        }
        if (is_overlapping_hole(foam, film)) {
            return shrink_hole(foam, film);
        }
    }
    if (length < collapsed) {
        return reopen_film(foam, film, kReopenedLength * collapsed);
    }
    const bool flips = should_flip_or_tear(foam, film, thresholds);
    if (flips) {
        flip_film(foam, film);
    }
    return flips;
}

int apply_t1_rule(Foam& foam, std::span<const FilmId> films, const TopologyThresholds& thresholds) {
    int changes = 0;
    for (const FilmId film : films) {
        const bool is_live = foam.network.is_live(film);  // an earlier change may have removed it
        changes += is_live && apply_t1_rule(foam, film, thresholds) ? 1 : 0;
    }
    return changes;
}

std::vector<FilmId> short_films(const Foam& foam, const TopologyThresholds& thresholds) {
    std::vector<FilmId> films;
    for (const FilmId film : foam.network.films()) {
        if (should_flip_or_tear(foam, film, thresholds)) {
            films.push_back(film);
        }
    }
    return films;
}

void rearm_grown_films(Foam& foam,
                       std::span<const FilmId> films,
                       const TopologyThresholds& thresholds) {
    for (const FilmId film : films) {
        if (foam.t1_armed[film] == 0) {
            const double length = chord(foam, forward_side(film)).norm();
            const bool grown = length > kRearmingFactor * scaled_distance(foam, film, thresholds);
            foam.t1_armed[film] = grown ? 1 : 0;
        }
    }
}

void rearm_grown_films(Foam& foam, const TopologyThresholds& thresholds) {
    const Network& network = foam.network;
    rearm_grown_films(foam, network.films().ids(network.film_count()), thresholds);
}

}  // namespace foam
