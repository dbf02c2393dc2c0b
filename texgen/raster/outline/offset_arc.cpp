#include "texgen/raster/outline/offset_arc.h"

#include <algorithm>
#include <cmath>

namespace foam::texgen {

OffsetArc place(const PixelArc& arc, const Vec2& tail) {
    const double length = arc.chord.norm();
    const Vec2 direction = arc.chord / length;
    const double reach = length / (1.0 + arc.cosine);
    const Vec2 middle = tail + 0.5 * (arc.chord - reach * arc.sine * turned_left(direction));
    return {middle, direction, 2.0 * arc.sine / length, arc.cosine, arc.sine, reach};
}

Vec2 tail_tangent(const OffsetArc& arc) {
    return arc.cosine * arc.direction - arc.sine * turned_left(arc.direction);
}

Vec2 head_tangent(const OffsetArc& arc) {
    return arc.cosine * arc.direction + arc.sine * turned_left(arc.direction);
}

OffsetArc offset_left(const OffsetArc& arc, double distance) {
    OffsetArc offset = arc;
    offset.middle += distance * turned_left(arc.direction);
    offset.curvature /= shrinkage(arc, distance);
    offset.reach *= shrinkage(arc, distance);
    return offset;
}

OffsetArc corner_arc(const OffsetArc& before, const OffsetArc& after, double distance) {
    const Vec2 from = head_tangent(before);
    const Vec2 to = tail_tangent(after);
    const Vec2 bisector = from + to;
    OffsetArc cap;
    cap.direction = bisector.norm() > 0.0 ? Vec2(bisector.normalized()) : Vec2(-turned_left(from));
    cap.middle = point_at(before, before.reach) + distance * turned_left(cap.direction);
    cap.curvature = -1.0 / distance;
    cap.cosine = 0.5 * bisector.norm();
    cap.sine = -0.5 * (to - from).norm();
    cap.reach = -2.0 * distance * cap.sine / (1.0 + cap.cosine);
    return cap;
}

Vec2 point_at(const OffsetArc& arc, double parameter) {
    const double tangent = 0.5 * arc.curvature * parameter;
    const double scale = parameter / (1.0 + tangent * tangent);
    return arc.middle + scale * (arc.direction + tangent * turned_left(arc.direction));
}

// Parameters are proportional to tangents of half the angle turned since the middle; the half angle
// of the piece is the difference of two such halves.
PixelArc piece(const OffsetArc& arc, double from, double to, const Vec2& chord) {
    const double half = 0.5 * arc.curvature;
    const double sine = half * (to - from);
    const double cosine = 1.0 + half * half * from * to;
    const double scale = 1.0 / std::sqrt(sine * sine + cosine * cosine);
    return {chord, cosine * scale, sine * scale};
}

// With y(s) = s / (1 + (k s / 2)²) (t + (k s / 2) n) the points of the one circle, relative to its
// middle, the equation of the other, n' (y - q) - k' / 2 |y - q|² = 0, becomes
// a s² + b s - e = 0. Each root is computed in the form that does not cancel.
Crossings crossings(const OffsetArc& arc, const OffsetArc& other) {
    const Vec2 q = other.middle - arc.middle;
    const Vec2 m = other.curvature * q + turned_left(other.direction);
    const double e = cross(other.direction, q) + 0.5 * other.curvature * q.squaredNorm();
    const double b = m.dot(arc.direction);
    const double across = cross(arc.direction, m);
    const double a =
        0.5 * (arc.curvature * across - other.curvature) - 0.25 * e * arc.curvature * arc.curvature;
    const double slope = std::sqrt(b * b + 4.0 * a * e);  // minus it at the one, plus at the other
    return {b <= 0.0 ? -2.0 * e / (slope - b) : -(b + slope) / (2.0 * a),
            b >= 0.0 ? 2.0 * e / (b + slope) : (slope - b) / (2.0 * a)};
}

// With v the coordinate of the point along the normal in the middle, and d its distance from the
// circle, the nearest point of the circle has the parameter 2 u / (2 - k v - k d).
double distance(const OffsetArc& arc, const Vec2& point) {
    const Vec2 y = point - arc.middle;
    const double u = arc.direction.dot(y);
    const double v = cross(arc.direction, y);
    const double left =
        distance_left(arc.direction.x(), arc.direction.y(), arc.curvature, y.x(), y.y());
    if (2.0 * std::abs(u) < arc.reach * (2.0 - arc.curvature * (v + left))) {
        return std::abs(left);
    }
    return std::sqrt(std::min((point - point_at(arc, -arc.reach)).squaredNorm(),
                              (point - point_at(arc, arc.reach)).squaredNorm()));
}

double extent(const OffsetArc& arc) {
    return arc.reach * std::sqrt(0.5 * (1.0 + arc.cosine));
}

}  // namespace foam::texgen
