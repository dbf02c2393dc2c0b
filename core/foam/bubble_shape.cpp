// SPDX-License-Identifier: Apache-2.0

#include "core/foam/bubble_shape.h"

#include "core/foam/measure.h"
#include "core/geometry/elementary.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace foam {

namespace {

// Moments of a region about the origin: the integrals of 1, x and x xᵀ over the region, where x is
// the position vector.
struct AreaMoments {
    double area = 0.0;
    Vec2 first{0.0, 0.0};
    Mat2 second = Mat2::Zero();
};

// Adds the triangle between the origin, a and b. Its moments are negative if it is clockwise.
void add_triangle(AreaMoments& sum, const Vec2& a, const Vec2& b) {
    const double area = 0.5 * cross(a, b);
    const Vec2 sum_of_ends = a + b;
    sum.area += area;
    sum.first += area / 3.0 * sum_of_ends;
    sum.second += area / 12.0 *
                  (a * a.transpose() + b * b.transpose() + sum_of_ends * sum_of_ends.transpose());
}

// Adds the segment between an arc and its chord. `middle` is the middle of the chord. Precondition:
// the chord is not zero.
void add_segment(AreaMoments& sum, const FilmArc& arc, const Vec2& middle) {
    const SegmentMoments segment = segment_moments(arc);
    const Vec2 along = arc.chord.normalized();
    const Vec2 left = turned_left(along);
    const Vec2 offset = segment.y * left;  // first moment of the segment about `middle`
    sum.area += segment.area;
    sum.first += segment.area * middle + offset;
    sum.second += segment.area * middle * middle.transpose() + middle * offset.transpose() +
                  offset * middle.transpose() + segment.xx * along * along.transpose() +
                  segment.yy * left * left.transpose();
}

// Returns the moments of a bubble about the tail of its first half-edge.
AreaMoments moments_of(const Frame& frame, BubbleId bubble) {
    AreaMoments sum;
    Vec2 start = Vec2::Zero();
    for (const HalfEdgeId h : frame.network.around(bubble)) {
        const FilmArc arc = frame.arc(h);
        const Vec2 end = start + arc.chord;
        add_triangle(sum, start, end);
        if (arc.chord != Vec2::Zero()) {
            add_segment(sum, arc, 0.5 * (start + end));
        }
        start = end;
    }
    return sum;
}

// Sets elongation and orientation. The matrix of the second moments about the center of area has
// the eigenvalues `mean` + `spread` and `mean` - `spread`. Each is proportional to the square of an
// axis of the ellipse. Sets nothing if an eigenvalue is not positive.
void set_ellipse(BubbleShape& shape, const AreaMoments& moments) {
    const Mat2 central = moments.second - moments.first * moments.first.transpose() / moments.area;
    const double mean = 0.5 * (central(0, 0) + central(1, 1));
    const double difference = 0.5 * (central(0, 0) - central(1, 1));
    const double spread = std::sqrt(difference * difference + central(0, 1) * central(0, 1));
    if (mean > spread) {
        shape.elongation = std::sqrt((mean + spread) / (mean - spread));
        shape.orientation = 0.5 * ieee::atan2(central(0, 1), difference);
    }
}

}  // namespace

BubbleShape bubble_shape(const Frame& frame, BubbleId bubble) {
    BubbleShape shape;
    for (const HalfEdgeId h : frame.network.around(bubble)) {
        shape.perimeter += arc_length(frame.arc(h));
    }
    shape.center = frame.positions[frame.network.tail(frame.network.first(bubble))];
    shape.elongation = shape.orientation = std::numeric_limits<double>::quiet_NaN();
    const AreaMoments moments = moments_of(frame, bubble);
    if (moments.area > 0.0) {
        shape.center += moments.first / moments.area;
        set_ellipse(shape, moments);
    }
    return shape;
}

BubbleShape bubble_shape(const LoneBubble& bubble) {
    return {.center = bubble.center, .perimeter = 2.0 * std::numbers::pi * lone_radius(bubble)};
}

}  // namespace foam
