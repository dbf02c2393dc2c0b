// SPDX-License-Identifier: Apache-2.0

#include "core/foam/bubble_centroid.h"

#include "core/geometry/trigonometric.h"

namespace foam {

namespace {

// Returns the first moment of the area between an arc and its chord about the middle of the chord,
// in the direction to the right of the chord. With c the length of the chord and S the area, the
// centroid is at the distance c³ / (12 S) from the center of the circle.
double segment_moment(const FilmArc& arc, double area) {
    if (arc.half_angle == 0.0) {
        return 0.0;
    }
    const double c = arc.chord.norm();
    return c * c * c / 12.0 - area * c / (2.0 * ieee::tan(arc.half_angle));
}

}  // namespace

Vec2 bubble_centroid(const Frame& frame, BubbleId bubble) {
    const HalfEdgeId first = frame.network.first(bubble);
    Vec2 tail(0.0, 0.0);  // relative to the tail of the first half-edge, which keeps rounding small
    Vec2 moment(0.0, 0.0);
    double area = 0.0;
    for (const HalfEdgeId h : frame.network.around(bubble)) {
        const FilmArc arc = frame.arc(h);
        const Vec2 head = tail + arc.chord;
        const double triangle = 0.5 * cross(tail, head);
        const double segment = segment_area(arc);
        const double c = arc.chord.norm();
        moment += triangle / 3.0 * (tail + head) + segment * 0.5 * (tail + head);
        if (c > 0.0) {
            moment -= segment_moment(arc, segment) / c * turned_left(arc.chord);
        }
        area += triangle + segment;
        tail = head;
    }
    const Vec2& origin = frame.positions[frame.network.tail(first)];
    return area == 0.0 ? origin : Vec2(origin + moment / area);
}

}  // namespace foam
