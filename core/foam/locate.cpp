// SPDX-License-Identifier: Apache-2.0

#include "core/foam/locate.h"

#include "core/foam/measure.h"

#include <algorithm>
#include <cmath>
#include <limits>

// Locates points by winding numbers. The winding number of an outline of arcs is the winding number
// of the polygon of its chords, plus or minus 1 for each circular segment between a chord and its
// arc that contains the point. The winding number of the polygon is counted by crossings of a ray
// to the right. By the inscribed angle theorem, a point is inside a segment if it is on the side of
// the arc and the chord subtends an angle of more than 180 degrees minus the half angle at the
// point. A point that is on a film up to rounding may have a winding number of 0 for every bubble;
// bubble_at then tries points nearby.

namespace foam {

namespace {

// Step by which bubble_at moves a point that no bubble contains, in square roots of the mean area.
constexpr double kNudge = 1e-7;

// Returns the contribution of a chord to the winding number around the origin: 1 if it crosses the
// ray to the right upwards, -1 if downwards, otherwise 0.
int ray_crossings(const Vec2& from, const Vec2& to) {
    if ((from.y() <= 0.0) == (to.y() <= 0.0)) {
        return 0;
    }
    const bool upwards = from.y() <= 0.0;
    const bool origin_is_left = cross(to - from, -from) > 0.0;
    return upwards == origin_is_left ? (upwards ? 1 : -1) : 0;
}

// Returns true if the origin is between an arc that starts at `from` and its chord: on the side to
// which the arc bulges, where the angle that the chord subtends is more than 180 degrees minus the
// half angle.
bool is_in_segment(const Vec2& from, const FilmArc& arc) {
    const Vec2 to = from + arc.chord;
    const double side = cross(from, to);  // positive if the origin is on the left
    const double angle = std::atan2(std::abs(side), -from.dot(to));
    return angle < std::abs(arc.half_angle) && (arc.half_angle > 0.0) == (side < 0.0);
}

struct BubbleOutline {
    std::vector<Vec2> corners;  // relative to the first, in the plane
    std::vector<FilmArc> arcs;
    double reach = 0.0;  // no point of the outline is farther from the first corner
};

BubbleOutline outline_of(const Foam& foam, BubbleId bubble) {
    BubbleOutline outline;
    Vec2 at = Vec2::Zero();
    for (const HalfEdgeId h : foam.network.around(bubble)) {
        const FilmArc arc = film_arc(foam, h);
        outline.corners.push_back(at);
        outline.arcs.push_back(arc);
        outline.reach = std::max(outline.reach, at.norm() + arc_length(arc));
        at += arc.chord;
    }
    return outline;
}

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

std::optional<BubbleId> bubble_around(const Foam& foam, const Vec2& point) {
    for (const BubbleId bubble : foam.network.bubbles()) {
        if (winding_number(foam, bubble, point) > 0) {
            return bubble;
        }
    }
    return std::nullopt;
}

double distance_to_segment(const Vec2& from, const Vec2& along) {
    const double squared = along.squaredNorm();
    const double part = squared == 0.0 ? 0.0 : std::clamp(-from.dot(along) / squared, 0.0, 1.0);
    return (from + part * along).norm();
}

// Returns the distance from a film's chord to the nearest copy of the point. Tries all copies near
// the chord, because the chord may be longer than the periods of the torus.
double distance_to_chord(const Foam& foam, FilmId film, const Vec2& point) {
    const HalfEdgeId h = forward_side(film);
    const Vec2 along = chord(foam, h);
    const Vec2 from = foam.domain.nearest_copy(foam.positions[foam.network.tail(h)] - point);
    double min_distance = std::numeric_limits<double>::infinity();
    for (const LatticeOffset offset : foam.domain.offsets_near(Vec2::Zero(), along.norm())) {
        const Vec2 copy = from + foam.domain.translation(offset);
        min_distance = std::min(min_distance, distance_to_segment(copy, along));
    }
    return min_distance;
}

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
        const Vec2 direction(std::cos(k), std::sin(k));
        if (const auto bubble = bubble_around(foam, point + k * nudge * direction)) {
            return bubble;
        }
    }
    // Bubbles cover a torus: some bubble contains the point, even if rounding hides which one.
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
