// SPDX-License-Identifier: Apache-2.0

#include "core/foam/rafts.h"

#include "core/foam/measure.h"
#include "core/foam/record_event.h"
#include "core/geometry/elementary.h"
#include "core/network/split.h"
#include "core/network/t1.h"
#include "core/network/t2.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <vector>

// Implements the topology changes at the ghost of a patch: films tear, and small holes close. The
// tearing of a film separates rafts, or joins a hole to the outside or to another hole. The ghost
// has several boundaries if there are several rafts or holes. The network does not store which of
// these boundaries are holes, so holes are recognized by the signed area that a boundary encloses.
// The outer boundary of a raft runs clockwise, because the ghost is on its left, and has a large
// negative area. A hole has a positive area, or a small negative area if the bubbles around it
// overlap.

namespace foam {

namespace {

constexpr std::size_t kMaxSidesOfSmallHole = 3;
// The outer boundary of a raft encloses more than this fraction of the total target area of the
// bubbles along it.
constexpr double kRaftAreaFraction = 0.5;

// One of the two outer films that result when a film tears. For each of the two bubbles beside the
// torn film, the two outer films of the bubble that end at the torn film become one joined film.
struct JoinedFilm {
    // The bubble's half-edge directly before the torn film. It becomes a half-edge of the joined
    // film. But if the bubble has only one film besides the torn one, there is no joined film, and
    // the bubble becomes a lone bubble.
    HalfEdgeId kept;
    Vec2 at_tail;        // unit tangent at the tail of the joined film
    Vec2 at_head;        // unit tangent at the head of the joined film
    LoneBubble as_lone;  // used only if the bubble becomes a lone bubble
};

// Returns the bubble on the left of h as a lone bubble, a circle that is tangent to the film of h
// at the tail of h. A bubble that has lost all its gas is a point; it vanishes at once.
LoneBubble as_lone(const Foam& foam, HalfEdgeId h) {
    const BubbleId bubble = foam.network.left(h);
    LoneBubble lone{foam.identities[bubble], Vec2::Zero(), foam.target_areas[bubble]};
    const double radius = lone.target_area > 0.0 ? lone_radius(lone) : 0.0;
    lone.center = foam.positions[foam.network.tail(h)] +
                  radius * turned_left(tangent_at_tail(film_arc(foam, h)));
    return lone;
}

// Returns the outer film that joins `before` and `after`, the half-edges of a bubble before and
// after the torn film.
JoinedFilm joined_film(const Foam& foam, HalfEdgeId before, HalfEdgeId after) {
    return {before,
            tangent_at_tail(film_arc(foam, before)),
            tangent_at_head(film_arc(foam, after)),
            as_lone(foam, before)};
}

// Returns the counter-clockwise angle from a to b, in radians, from -pi to pi.
double angle_between(const Vec2& a, const Vec2& b) {
    return ieee::atan2(cross(a, b), a.dot(b));
}

// Sets the half angle of the joined film to the mean of the two half angles that its tangents at
// the tail and at the head require. Also arms the film, which gives it the full T1 distance
// (Foam::t1_armed).
void fit_half_angle_of_joined_film(Foam& foam, const JoinedFilm& side) {
    const Vec2 d = chord(foam, side.kept);
    const double angle = 0.5 * (angle_between(side.at_tail, d) + angle_between(d, side.at_head));
    set_half_angle(foam, side.kept, angle);
    foam.t1_armed[film_of(side.kept)] = 1;
}

// Inserts the bubble so that the list stays ordered by identity.
void add_lone(Foam& foam, const LoneBubble& bubble) {
    const auto position =
        std::find_if(foam.lone_bubbles.begin(), foam.lone_bubbles.end(), [&](const LoneBubble& b) {
            return b.identity > bubble.identity;
        });
    foam.lone_bubbles.insert(position, bubble);
}

// Returns the half-edges of the ghost's boundary that contains the outer film, in order.
std::vector<HalfEdgeId> boundary_at(const Network& network, FilmId film) {
    const HalfEdgeId forward = forward_side(film);
    const HalfEdgeId first = network.left(forward) == network.ghost() ? forward : twin(forward);
    std::vector<HalfEdgeId> boundary;
    HalfEdgeId h = first;
    do {
        boundary.push_back(h);
        h = network.next(h);
    } while (h != first);
    return boundary;
}

// Returns the sum of the target areas of the bubbles along a boundary.
double area_along(const Foam& foam, const std::vector<HalfEdgeId>& boundary) {
    std::vector<BubbleId> bubbles;
    bubbles.reserve(boundary.size());
    for (const HalfEdgeId h : boundary) {
        bubbles.push_back(foam.network.right(h));
    }
    std::sort(bubbles.begin(), bubbles.end());
    const auto end = std::unique(bubbles.begin(), bubbles.end());
    return std::accumulate(bubbles.begin(), end, 0.0, [&](double sum, BubbleId bubble) {
        return sum + foam.target_areas[bubble];
    });
}

// Returns the area that the arcs of a boundary enclose. It is negative for the outer boundary of a
// raft, which runs clockwise.
double enclosed_area(const Foam& foam, const std::vector<HalfEdgeId>& boundary) {
    double area = 0.0;
    Vec2 corner = Vec2::Zero();
    for (const HalfEdgeId h : boundary) {
        const FilmArc arc = film_arc(foam, h);
        area += 0.5 * cross(corner, arc.chord) + segment_area(arc);
        corner += arc.chord;
    }
    return area;
}

// Returns true if the boundary is a hole, and false if it is the outer boundary of a raft.
// `enclosed` is its enclosed_area. The outer boundary runs clockwise and encloses at least all
// bubbles along it. The bubbles around a hole may overlap; this function assumes that they overlap
// by less than half of their total area.
bool is_around_hole(const Foam& foam, const std::vector<HalfEdgeId>& boundary, double enclosed) {
    return enclosed > -kRaftAreaFraction * area_along(foam, boundary);
}

}  // namespace

bool is_inside_double_bubble(const Network& network, FilmId film) {
    const HalfEdgeId h = forward_side(film);
    return can_split(network, film) && network.sides(network.left(h)) == 2 &&
           network.sides(network.right(h)) == 2;
}

void tear_film(Foam& foam, FilmId film) {
    const T1Site site = t1_site(foam.network, film);
    const std::array<JoinedFilm, 2> sides{joined_film(foam, site.before_left, site.after_left),
                                          joined_film(foam, site.before_right, site.after_right)};
    const std::array<BubbleId, 2> bubbles{foam.network.left(site.film),
                                          foam.network.right(site.film)};
    record_t1(foam, film);
    split(foam.network, film);
    for (std::size_t k = 0; k < 2; ++k) {
        if (foam.network.is_live(bubbles[k])) {
            fit_half_angle_of_joined_film(foam, sides[k]);
        } else {
            add_lone(foam, sides[k].as_lone);
        }
    }
}

bool is_small_hole(const Foam& foam, FilmId film, double length) {
    const std::vector<HalfEdgeId> boundary = boundary_at(foam.network, film);
    return boundary.size() <= kMaxSidesOfSmallHole &&
           std::all_of(boundary.begin(),
                       boundary.end(),
                       [&](HalfEdgeId h) { return chord(foam, h).norm() < length; }) &&
           is_around_hole(foam, boundary, enclosed_area(foam, boundary));
}

bool is_overlapping_hole(const Foam& foam, FilmId film) {
    const std::vector<HalfEdgeId> boundary = boundary_at(foam.network, film);
    const double enclosed = enclosed_area(foam, boundary);
    return enclosed < 0.0 && is_around_hole(foam, boundary, enclosed);
}

bool close_hole(Foam& foam, FilmId film) {
    const std::vector<HalfEdgeId> boundary = boundary_at(foam.network, film);
    if (boundary.size() > kMaxSidesOfSmallHole || !can_close_hole(foam.network, boundary)) {
        return false;
    }
    Vec2 mean = Vec2::Zero();
    for (const HalfEdgeId h : boundary) {
        mean += foam.positions[foam.network.tail(h)] / static_cast<double>(boundary.size());
    }
    std::vector<BubbleId> bubbles;
    bubbles.reserve(boundary.size());
    for (const HalfEdgeId h : boundary) {
        bubbles.push_back(foam.network.right(h));
    }
    record_event(foam, TopologyEventKind::T1, mean, bubbles);
    const Vanished vanished = close_hole(foam.network, boundary);
    if (vanished.junction != kNone<JunctionId>) {
        place_junction(foam, vanished.junction, mean);
    } else {
        foam.t1_armed[vanished.film] = 1;
        fit_half_angle(foam, vanished.film);
    }
    return true;
}

}  // namespace foam
