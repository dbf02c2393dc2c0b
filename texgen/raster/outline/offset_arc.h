// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/raster/arcs/pixel_arc.h"

#include <cmath>

namespace foam::texgen {

/// A point or a vector of the plane, as two numbers. Vec2 is not used here, because Eigen computes
/// both coordinates of a Vec2 in one SIMD register. This prevents compilers from vectorizing a loop
/// over many points.
struct Point {
    double x = 0.0;
    double y = 0.0;

    Point() = default;
    Point(double of_x, double of_y) : x(of_x), y(of_y) {}
    Point(const Vec2& v) : x(v.x()), y(v.y()) {}  // NOLINT: implicit
    operator Vec2() const { return {x, y}; }      // NOLINT

    double dot(Point b) const { return x * b.x + y * b.y; }
    double squared_norm() const { return dot(*this); }
    double norm() const { return std::sqrt(squared_norm()); }

    friend Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y}; }
    friend Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
    friend Point operator*(double factor, Point a) { return {factor * a.x, factor * a.y}; }
    friend Point operator/(Point a, double divisor) { return {a.x / divisor, a.y / divisor}; }
    friend double cross(Point a, Point b) { return a.x * b.y - a.y * b.x; }
    friend Point turned_left(Point v) { return {-v.y, v.x}; }
};

/// A side of a bubble, or the offset of a side or of a corner, in pixels. The bubble is on the left
/// of the arc.
///
/// The position of a point on the arc is given by the parameter s = 2 r tan(phi / 2), where r is
/// the signed radius (positive if the arc turns left) and phi the angle by which the arc turns left
/// from its middle to the point. The parameter is finite on every arc. If the arc is straight, the
/// parameter is the signed distance from the middle. Coordinates are rational functions of the
/// parameter and the curvature, so that no formula divides by the curvature.
///
/// FullInsets calls the inline functions below in vectorized loops over many arcs.
struct OffsetArc {
    Point middle;
    Point direction;         // unit tangent at the middle, in the direction from tail to head
    double curvature = 0.0;  // in 1 / pixels; positive if the arc turns left
    double cosine = 1.0;     // of half the angle by which the arc turns left
    double sine = 0.0;
    double reach = 0.0;  // parameter of the head; the parameter of the tail is -reach
};

/// A side has no offset if the radius of the offset would be below this fraction of the radius of
/// the side.
inline constexpr double kSmallestShrinkage = 1e-9;

/// Return the arc that has a given chord and half angle and starts at `tail`. `cosine` and `sine`
/// are the cosine and the sine of half the angle by which the arc turns left. Precondition: the
/// chord is not zero.
inline OffsetArc offset_arc_from(Point chord, double cosine, double sine, Point tail) {
    const double length = chord.norm();
    const Point direction = chord / length;
    const double reach = length / (1.0 + cosine);
    const Point middle = tail + 0.5 * (chord - (reach * sine) * turned_left(direction));
    return {middle, direction, 2.0 * sine / length, cosine, sine, reach};
}
inline OffsetArc offset_arc_from(const PixelArc& arc, Point tail) {
    return offset_arc_from(arc.chord, arc.cosine, arc.sine, tail);
}

/// Return the unit tangents at the ends of an arc, in the direction from tail to head.
inline Point tail_tangent(const OffsetArc& arc) {
    return arc.cosine * arc.direction - arc.sine * turned_left(arc.direction);
}
inline Point head_tangent(const OffsetArc& arc) {
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

/// Returns the offset of a corner at which a boundary turns right: the circular arc around the
/// corner, with the radius `distance`, from the offset of `before` to the offset of `after`.
OffsetArc corner_arc(const OffsetArc& before, const OffsetArc& after, double distance);

/// Returns the point that has a given parameter.
inline Point point_at(const OffsetArc& arc, double parameter) {
    const double tangent = 0.5 * arc.curvature * parameter;
    const double scale = parameter / (1.0 + tangent * tangent);
    return arc.middle + scale * (arc.direction + tangent * turned_left(arc.direction));
}

/// The cosine and the sine of half an angle.
struct HalfAngle {
    double cosine;
    double sine;
};

/// Returns half the angle by which an arc turns left between the points with two parameters. The
/// parameter of a point is proportional to the tangent of half the angle from the middle of the arc
/// to the point, so that the result follows from the formula for the tangent of a difference.
/// Precondition: from < to.
inline HalfAngle half_angle_between(double curvature, double from, double to) {
    const double half = 0.5 * curvature;
    const double sine = half * (to - from);
    const double cosine = 1.0 + half * half * from * to;
    const double scale = 1.0 / std::sqrt(sine * sine + cosine * cosine);
    return {cosine * scale, sine * scale};
}

/// The crossings of the circle of an arc with the circle of another arc, as parameters of the first
/// arc. In the direction of the first arc, the first circle crosses from the left of the other
/// circle to the right of it at `leaving`, and from the right to the left at `entering`. A
/// parameter is infinite or NaN if there is no such crossing.
struct Crossings {
    double leaving;
    double entering;
};

/// Computes the crossings of the circle of `arc` with the circle of `other`.
///
/// Let k be the curvature of `arc`, t its unit tangent at the middle, and n its normal (t turned
/// left). Let k' and n' be the curvature and the normal of `other`, and q the vector from the
/// middle of `arc` to the middle of `other`. The points of the first circle, relative to the middle
/// of `arc`, are
///     y(s) = s / (1 + (k s / 2)²) (t + (k s / 2) n).
/// Inserted into the equation of the second circle, n' (y - q) - k' / 2 |y - q|² = 0, they give a
/// quadratic equation for s, a s² + b s - e = 0, with the coefficients a, b and e of the code. Each
/// root is computed by the formula that avoids cancellation.
inline Crossings crossings(const OffsetArc& arc, const OffsetArc& other) {
    const Point q = other.middle - arc.middle;
    const Point m = other.curvature * q + turned_left(other.direction);
    const double e = cross(other.direction, q) + 0.5 * other.curvature * q.squared_norm();
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
double distance(const OffsetArc& arc, Point point);

/// Returns the radius of the smallest disc around the middle of the arc that contains the arc.
double extent(const OffsetArc& arc);

/// Returns the signed distance of a point from the circle of an arc, in pixels. It is positive on
/// the left of the arc.
///
/// Let y be the vector from the middle of the arc to the point, n the normal at the middle and k
/// the curvature. The function f = n y - k / 2 y² is 0 on the circle, with a gradient of length 1.
/// The squared distance from the center of the circle, divided by the squared radius, is 1 - 2 k f.
/// The signed distance from the circle is therefore 2 f / (1 + sqrt(1 - 2 k f)).
inline double distance_left(const OffsetArc& arc, Point point) {
    const Point y = point - arc.middle;
    const double f = cross(arc.direction, y) - 0.5 * arc.curvature * y.squared_norm();
    const double squared = 1.0 - 2.0 * arc.curvature * f;
    return 2.0 * f / (1.0 + std::sqrt(squared > 0.0 ? squared : 0.0));
}

}  // namespace foam::texgen
