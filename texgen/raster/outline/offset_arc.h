// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/raster/arcs/pixel_arc.h"

#include <cmath>

namespace foam::texgen {

/// A point or a vector of the plane as two numbers. Vec2 is not used here, because Eigen computes
/// it in vectors of two, which prevents compilers from vectorizing a loop over many points.
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

/// A side of a bubble, or the offset of a side, in pixels. The bubble is on its left.
///
/// The position of a point on the arc is given by the parameter s = 2 r tan(phi / 2), where r is
/// the radius and phi the angle by which the arc turns from its middle to the point. The parameter
/// is finite on every arc and equals the arc length on a straight one. Coordinates are rational
/// functions of the parameter, so that no formula divides by a curvature.
///
/// FullInsets vectorizes the inline functions below over many arcs.
struct OffsetArc {
    Point middle;
    Point direction;         // unit tangent at the middle
    double curvature = 0.0;  // 1 / pixels, positive where the arc turns left
    double cosine = 1.0;     // of half the angle by which it turns
    double sine = 0.0;
    double reach = 0.0;  // parameter of the head; the tail has -reach
};

/// An offset has vanished if its radius is below this fraction of the radius of its side.
inline constexpr double kSmallestShrinkage = 1e-9;

/// Return an arc with a given tail. `cosine` and `sine` are those of the half angle. Precondition:
/// the chord is not zero.
inline OffsetArc place(Point chord, double cosine, double sine, Point tail) {
    const double length = chord.norm();
    const Point direction = chord / length;
    const double reach = length / (1.0 + cosine);
    const Point middle = tail + 0.5 * (chord - (reach * sine) * turned_left(direction));
    return {middle, direction, 2.0 * sine / length, cosine, sine, reach};
}
inline OffsetArc place(const PixelArc& arc, Point tail) {
    return place(arc.chord, arc.cosine, arc.sine, tail);
}

/// Return the unit tangents at the ends.
inline Point tail_tangent(const OffsetArc& arc) {
    return arc.cosine * arc.direction - arc.sine * turned_left(arc.direction);
}
inline Point head_tangent(const OffsetArc& arc) {
    return arc.cosine * arc.direction + arc.sine * turned_left(arc.direction);
}

/// Returns the radius of the offset to the left divided by the radius of the arc. The ratio is 0 or
/// less if the arc turns left with a radius of at most `distance`.
inline double shrinkage(const OffsetArc& arc, double distance) {
    return 1.0 - arc.curvature * distance;
}

/// Returns the offset of an arc to the left. Precondition: shrinkage(arc, distance) > 0.
inline OffsetArc offset_left(const OffsetArc& arc, double distance) {
    const double shrunk = shrinkage(arc, distance);
    return {arc.middle + distance * turned_left(arc.direction),
            arc.direction,
            arc.curvature / shrunk,
            arc.cosine,
            arc.sine,
            arc.reach * shrunk};
}

/// Returns the offset of a right turn between two sides: the circular arc around the corner, from
/// the offset of the first side to the offset of the second side.
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

/// Returns half the angle by which an arc turns between two parameters. A parameter is proportional
/// to the tangent of half the angle from the middle of the arc to the point. The result is the
/// difference of two such half angles. Precondition: from < to.
inline HalfAngle half_angle_between(double curvature, double from, double to) {
    const double half = 0.5 * curvature;
    const double sine = half * (to - from);
    const double cosine = 1.0 + half * half * from * to;
    const double scale = 1.0 / std::sqrt(sine * sine + cosine * cosine);
    return {cosine * scale, sine * scale};
}

/// The parameters at which the circle of an arc crosses the circle of another arc, from its left to
/// its right (`leaving`) and from its right to its left (`entering`). A parameter is infinite or
/// NaN if there is no such crossing.
struct Crossings {
    double leaving;
    double entering;
};

/// Computes the crossings of the circle of `arc` with the circle of `other`.
///
/// The points of the first circle, relative to its middle, are
/// y(s) = s / (1 + (k s / 2)²) (t + (k s / 2) n). Inserted into the equation of the second circle,
/// n' (y - q) - k' / 2 |y - q|² = 0, they give a s² + b s - e = 0. Each root is computed in the
/// form that does not cancel.
inline Crossings crossings(const OffsetArc& arc, const OffsetArc& other) {
    const Point q = other.middle - arc.middle;
    const Point m = other.curvature * q + turned_left(other.direction);
    const double e = cross(other.direction, q) + 0.5 * other.curvature * q.squared_norm();
    const double b = m.dot(arc.direction);
    const double across = cross(arc.direction, m);
    const double a =
        0.5 * (arc.curvature * across - other.curvature) - 0.25 * e * arc.curvature * arc.curvature;
    const double slope = std::sqrt(b * b + 4.0 * a * e);  // -slope if leaving, else +slope
    return {(b <= 0.0 ? -2.0 * e : -(b + slope)) / (b <= 0.0 ? slope - b : 2.0 * a),
            (b >= 0.0 ? 2.0 * e : slope - b) / (b >= 0.0 ? b + slope : 2.0 * a)};
}

/// Returns the distance of a point from the nearest point of the arc.
double distance(const OffsetArc& arc, Point point);

/// Returns the radius of the smallest disc around the middle of the arc that contains the arc.
double extent(const OffsetArc& arc);

/// Returns the signed distance of a point from the circle of an arc, positive on the left.
///
/// Let y be the vector from the middle of the arc to the point, n the normal and k the curvature.
/// The function f = n y - k / 2 y² is 0 on the circle and has slope 1 there. The squared distance
/// from the center, divided by the squared radius, is 1 - 2 k f.
inline double distance_left(const OffsetArc& arc, Point point) {
    const Point y = point - arc.middle;
    const double f = cross(arc.direction, y) - 0.5 * arc.curvature * y.squared_norm();
    const double squared = 1.0 - 2.0 * arc.curvature * f;
    return 2.0 * f / (1.0 + std::sqrt(squared > 0.0 ? squared : 0.0));
}

}  // namespace foam::texgen
