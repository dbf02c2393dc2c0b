// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/raster/arcs/pixel_arc.h"

#include <cmath>

namespace foam::texgen {

/// A side of a bubble, or the offset of a side or of a corner, in pixels. The offset of a side is
/// the arc at a given distance on its left, that is, inside the bubble (offset_left). The offset of
/// a corner is an arc around the corner (corner_arc). The bubble is on the left of the arc.
///
/// The position of a point on the arc is given by the parameter s = 2 r tan(phi / 2). Here r is the
/// signed radius, positive if the arc turns left. From its middle to the point, the arc turns left
/// by the angle phi. On a straight arc, s is the signed distance from the middle. Coordinates are
/// rational functions of the parameter and the curvature, so that no formula divides by the
/// curvature.
struct OffsetArc {
    Vec2 middle{0.0, 0.0};
    Vec2 direction{1.0, 0.0};  // unit tangent at the middle, in the direction from tail to head
    double curvature = 0.0;    // in 1 / pixels; positive if the arc turns left
    double cosine = 1.0;       // cosine of half the angle by which the arc turns left
    double sine = 0.0;         // sine of the same half angle
    double reach = 0.0;        // parameter of the head; the parameter of the tail is -reach
};

/// A side has no offset if the radius of the offset would be below this fraction of the radius of
/// the side.
inline constexpr double kMinShrinkage = 1e-9;

/// Converts an arc that starts at `tail`. Precondition: the chord is not zero.
inline OffsetArc offset_arc_from(const PixelArc& arc, const Vec2& tail) {
    const double length = arc.chord.norm();
    const Vec2 direction = arc.chord / length;
    const double reach = length / (1.0 + arc.cosine);
    const Vec2 middle = tail + 0.5 * (arc.chord - (reach * arc.sine) * turned_left(direction));
    return {middle, direction, 2.0 * arc.sine / length, arc.cosine, arc.sine, reach};
}

/// Return the unit tangents at the ends of an arc, in the direction from tail to head.
inline Vec2 tail_tangent(const OffsetArc& arc) {
    return arc.cosine * arc.direction - arc.sine * turned_left(arc.direction);
}
inline Vec2 head_tangent(const OffsetArc& arc) {
    return arc.cosine * arc.direction + arc.sine * turned_left(arc.direction);
}

/// Returns the radius of the offset at a distance on the left of an arc, divided by the radius of
/// the arc. The ratio is 0 or negative if the arc turns left with a radius of at most `distance`.
inline double shrinkage(const OffsetArc& arc, double distance) {
    return 1.0 - arc.curvature * distance;
}

/// Returns the offset of an arc: the arc at a distance on its left. Precondition: shrinkage(arc,
/// distance) > 0.
inline OffsetArc offset_left(const OffsetArc& arc, double distance) {
    const double shrunk = shrinkage(arc, distance);
    return {arc.middle + distance * turned_left(arc.direction),
            arc.direction,
            arc.curvature / shrunk,
            arc.cosine,
            arc.sine,
            arc.reach * shrunk};
}

/// Returns the offset of a corner at which a boundary turns right. It is the circular arc around
/// the corner with the radius `distance`, from the offset of `before` to the offset of `after`.
OffsetArc corner_arc(const OffsetArc& before, const OffsetArc& after, double distance);

/// Returns the point that has a given parameter.
inline Vec2 point_at(const OffsetArc& arc, double parameter) {
    const double tangent = 0.5 * arc.curvature * parameter;
    const double scale = parameter / (1.0 + tangent * tangent);
    return arc.middle + scale * (arc.direction + tangent * turned_left(arc.direction));
}

/// The cosine and the sine of half an angle.
struct HalfAngle {
    double cosine;
    double sine;
};

/// Returns half the angle by which an arc turns left between the points with two parameters, by the
/// formula for the tangent of a difference. Precondition: from < to.
inline HalfAngle half_angle_between(double curvature, double from, double to) {
    const double half = 0.5 * curvature;
    const double sine = half * (to - from);
    const double cosine = 1.0 + half * half * from * to;
    const double scale = 1.0 / std::sqrt(sine * sine + cosine * cosine);
    return {cosine * scale, sine * scale};
}

/// The crossings of the circle of an arc with another circle, as parameters of the arc. Let a point
/// move along the circle of the arc, in the direction of the arc. It passes from the left of the
/// other circle to its right at `leaving`, and from its right to its left at `entering`. A
/// parameter is infinite or NaN if there is no such crossing.
struct Crossings {
    double leaving;
    double entering;
};

/// Computes the crossings of the circle of `arc` with the circle of `other`.
///
/// Let k be the curvature of `arc`, t its unit tangent at the middle, and n its normal (t turned
/// left). Let k' and n' be the curvature and the normal of `other`. Let q be the vector from the
/// middle of `arc` to the middle of `other`. Relative to the middle of `arc`, the points of the
/// first circle are
///     y(s) = s / (1 + (k s / 2)²) (t + (k s / 2) n).
/// They are inserted into the equation of the second circle,
///     n' · (y - q) - k' / 2 |y - q|² = 0.
/// The result is a quadratic equation for s, a s² + b s - e = 0, with the coefficients a, b and e
/// of the code. Each root is computed by the formula that avoids cancellation.
inline Crossings crossings(const OffsetArc& arc, const OffsetArc& other) {
    const Vec2 q = other.middle - arc.middle;
    const Vec2 m = other.curvature * q + turned_left(other.direction);
    const double e = cross(other.direction, q) + 0.5 * other.curvature * q.squaredNorm();
    const double b = m.dot(arc.direction);
    const double across = cross(arc.direction, m);
    const double a =
        0.5 * (arc.curvature * across - other.curvature) - 0.25 * e * arc.curvature * arc.curvature;
    // The derivative of the quadratic is `slope` at `entering` and -slope at `leaving`.
    const double slope = std::sqrt(b * b + 4.0 * a * e);
    return {(b <= 0.0 ? -2.0 * e : -(b + slope)) / (b <= 0.0 ? slope - b : 2.0 * a),
            (b >= 0.0 ? 2.0 * e : slope - b) / (b >= 0.0 ? b + slope : 2.0 * a)};
}

/// Returns the distance from a point to the nearest point of an arc, in pixels.
double distance(const OffsetArc& arc, const Vec2& point);

/// Returns the radius of the smallest disc around the middle of the arc that contains the arc.
double extent(const OffsetArc& arc);

/// Returns the signed distance of a point from the circle of an arc, positive on the left of the
/// arc.
///
/// Let y be the vector from the middle of the arc to the point, n the normal at the middle and k
/// the curvature. The function f = n · y - k / 2 |y|² is 0 on the circle. The squared distance from
/// the center of the circle, divided by the squared radius, is 1 - 2 k f. The signed distance from
/// the circle is therefore 2 f / (1 + sqrt(1 - 2 k f)).
inline double distance_left(const OffsetArc& arc, const Vec2& point) {
    const Vec2 y = point - arc.middle;
    const double f = cross(arc.direction, y) - 0.5 * arc.curvature * y.squaredNorm();
    const double squared = 1.0 - 2.0 * arc.curvature * f;
    return 2.0 * f / (1.0 + std::sqrt(squared > 0.0 ? squared : 0.0));
}

}  // namespace foam::texgen
