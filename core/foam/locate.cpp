// SPDX-License-Identifier: Apache-2.0

#include "core/foam/locate.h"

#include "core/foam/measure.h"
#include "core/geometry/elementary.h"

#include <algorithm>
#include <cmath>
#include <limits>

// Locates points by winding numbers. The winding number of an outline of arcs is a sum of two
// parts. The first part is the winding number of the polygon of the chords. It counts the crossings
// of the polygon's sides with the ray from the point to the right. An upward crossing counts as 1,
// a downward crossing as -1. The second part is plus or minus 1 for each arc that has the point
// between itself and its chord. By the inscribed angle theorem, a point is between an arc and its
// chord under two conditions:
// - it is on the same side of the chord as the arc;
// - the chord, seen from the point, subtends an angle of more than 180 degrees minus the half angle
//   of the arc.
//
// If a point is on a film, rounding may make the winding number of every bubble 0; bubble_at then
// tries points nearby.

namespace foam {

namespace {

// If no bubble contains a point, bubble_at tries other points whose distances from it are multiples
// of kNudge. The unit of kNudge is the square root of the mean target area.
constexpr double kNudge = 1e-7;

// Returns the contribution of a chord to the winding number around the origin: 1 if the chord
// crosses the positive x axis upwards, -1 if downwards, otherwise 0.
int ray_crossings(const Vec2& from, const Vec2& to) {
    if ((from.y() <= 0.0) == (to.y() <= 0.0)) {
        return 0;
    }
    const bool upwards = from.y() <= 0.0;
    const bool origin_is_left = cross(to - from, -from) > 0.0;
    return upwards == origin_is_left ? (upwards ? 1 : -1) : 0;
}

// Returns true if the origin is between an arc and its chord. The arc starts at `from`. The
// criterion is given at the top of this file.
bool is_in_segment(const Vec2& from, const FilmArc& arc) {
    const Vec2 to = from + arc.chord;
    const double side = cross(from, to);  // positive if the origin is on the left
    const double angle = ieee::atan2(std::abs(side), -from.dot(to));
    return angle < std::abs(arc.half_angle) && (arc.half_angle > 0.0) == (side < 0.0);
}

struct BubbleOutline {
    std::vector<Vec2> corners;  // in the plane, relative to the first corner
    std::vector<FilmArc> arcs;
    double reach = 0.0;  // upper bound of the distance from the first corner to any point of the
                         // outline
};

BubbleOutline outline_of(const Foam& foam, BubbleId bubble) {
    BubbleOutline outline;
    Vec2 corner = Vec2::Zero();
    for (const HalfEdgeId h : foam.network.around(bubble)) {
        const FilmArc arc = film_arc(foam, h);
        outline.corners.push_back(corner);
        outline.arcs.push_back(arc);
        outline.reach = std::max(outline.reach, corner.norm() + arc_length(arc));
        corner += arc.chord;
    }
    return outline;
}

// Returns the winding number of the outline around a point. The coordinates of the point are
// relative to the first corner of the outline.
int winding_around(const BubbleOutline& outline, const Vec2& point) {
    int winding = 0;
    for (std::size_t k = 0; k < outline.arcs.size(); ++k) {
        const FilmArc& arc = outline.arcs[k];
        const Vec2 from = outline.corners[k] - point;
        winding += ray_crossings(from, from + arc.chord);
        if (is_in_segment(from, arc)) {
            winding += arc.half_angle > 0.0 ? 1 : -1;
        }
    }
    return winding;
}

double mean_target_area(const Foam& foam) {
    double sum = 0.0;
    for (const BubbleId bubble : foam.network.bubbles()) {
        sum += foam.target_areas[bubble];
    }
    return sum / std::max(1.0, static_cast<double>(foam.network.bubble_count()));
}

// Returns the first bubble with a positive winding number around the point, or nothing.
std::optional<BubbleId> bubble_around(const Foam& foam, const Vec2& point) {
    for (const BubbleId bubble : foam.network.bubbles()) {
        if (winding_number(foam, bubble, point) > 0) {
            return bubble;
        }
    }
    return std::nullopt;
}

// Returns the distance from the origin to the straight segment from `from` to `from` + `along`.
double distance_to_segment(const Vec2& from, const Vec2& along) {
    const double squared = along.squaredNorm();
    const double part = squared == 0.0 ? 0.0 : std::clamp(-from.dot(along) / squared, 0.0, 1.0);
    return (from + part * along).norm();
}

// Returns the distance from a point to the nearest lattice copy of a film's chord. Tries all copies
// near the point, because the chord may be longer than the periods of the torus. Let `from` be the
// vector from the point to the nearest copy of the chord's tail, and `along` the chord. The
// distance from the point to this copy of the chord is at most |from|. The tail of a nearer copy is
// therefore at most |from| + |along| away from the point.
double distance_to_chord(const Foam& foam, FilmId film, const Vec2& point) {
    const HalfEdgeId h = forward_side(film);
    const Vec2 along = chord(foam, h);
    const Vec2 from = foam.domain.nearest_copy(foam.positions[foam.network.tail(h)] - point);
    double min_distance = std::numeric_limits<double>::infinity();
    for (const LatticeOffset offset : foam.domain.offsets_near(-from, from.norm() + along.norm())) {
        const Vec2 copy = from + foam.domain.translation(offset);
        min_distance = std::min(min_distance, distance_to_segment(copy, along));
    }
    return min_distance;
}

// Returns the id with the smallest distance, or the first such id if several have this distance.
template <class Id>
Id argmin(const LiveRange<Id>& ids, const auto& distance) {
    Id nearest = *ids.begin();
    double min_distance = std::numeric_limits<double>::infinity();
    for (const Id id : ids) {
        const double current = distance(id);
        nearest = current < min_distance ? id : nearest;
        min_distance = std::min(min_distance, current);
    }
    return nearest;
}

}  // namespace

std::optional<BubbleId> find_bubble(const Foam& foam, BubbleIdentity identity) {
    for (const BubbleId bubble : foam.network.bubbles()) {
        if (foam.identities[bubble] == identity) {
            return bubble;
        }
    }
    return std::nullopt;
}

bool is_present(const Foam& foam, BubbleIdentity identity) {
    return find_bubble(foam, identity) ||
           std::any_of(foam.lone_bubbles.begin(),
                       foam.lone_bubbles.end(),
                       [&](const LoneBubble& bubble) { return bubble.identity == identity; });
}

int winding_number(const Foam& foam, BubbleId bubble, const Vec2& point) {
    const BubbleOutline outline = outline_of(foam, bubble);
    const Vec2& first = foam.positions[foam.network.tail(foam.network.first(bubble))];
    int winding = 0;
    for (const LatticeOffset copy : foam.domain.offsets_near(point - first, outline.reach)) {
        winding += winding_around(outline, point - first - foam.domain.translation(copy));
    }
    return winding;
}

std::optional<BubbleId> bubble_at(const Foam& foam, const Vec2& point) {
    const double nudge = kNudge * std::sqrt(mean_target_area(foam));
    for (int k = 0; k < 8; ++k) {
        const Vec2 direction = unit_vector(k);
        if (const auto bubble = bubble_around(foam, point + k * nudge * direction)) {
            return bubble;
        }
    }
    // The bubbles of a torus cover it, so that one of them contains the point. Rounding hides which
    // bubble it is, so the first bubble is returned.
    return foam.domain.is_plane() ? std::nullopt : std::optional(*foam.network.bubbles().begin());
}

std::optional<BubbleIdentity> identity_at(const Foam& foam, const Vec2& point) {
    if (const auto bubble = bubble_at(foam, point)) {
        return foam.identities[*bubble];
    }
    for (const LoneBubble& bubble : foam.lone_bubbles) {
        if ((point - bubble.center).norm() <= lone_radius(bubble)) {
            return bubble.identity;
        }
    }
    return std::nullopt;
}

std::vector<BubbleId> bubbles_of_sides(const Foam& foam, int sides) {
    std::vector<BubbleId> found;
    for (const BubbleId bubble : foam.network.bubbles()) {
        if (foam.network.sides(bubble) == sides) {
            found.push_back(bubble);
        }
    }
    std::stable_sort(found.begin(), found.end(), [&](BubbleId a, BubbleId b) {
        return foam.target_areas[a] < foam.target_areas[b];
    });
    return found;
}

JunctionId nearest_junction(const Foam& foam, const Vec2& point) {
    return argmin(foam.network.junctions(), [&](JunctionId junction) {
        return foam.domain.nearest_copy(foam.positions[junction] - point).norm();
    });
}

FilmId nearest_film(const Foam& foam, const Vec2& point) {
    return argmin(foam.network.films(),
                  [&](FilmId film) { return distance_to_chord(foam, film, point); });
}

}  // namespace foam
