#pragma once

#include "texgen/raster/arcs/pixel_arc.h"

#include <cmath>

namespace foam::texgen {

/// A side of a bubble, or the offset of one, placed in the plane (pixels), with the bubble on its
/// left.
///
/// A point of it has the parameter s = 2 r tan(phi / 2), where r is the radius and phi the angle
/// turned since the middle. It is finite on every arc, equals the arc length on a straight one, and
/// is rational in the coordinates, so that no formula divides by a curvature.
struct OffsetArc {
    Vec2 middle{0.0, 0.0};
    Vec2 direction{0.0, 0.0};  // unit tangent in the middle
    double curvature = 0.0;    // 1 / pixels, positive where the arc turns left
    double cosine = 1.0;       // of half the angle that it turns
    double sine = 0.0;
    double reach = 0.0;  // parameter of the head; that of the tail is -reach
};

/// An offset whose radius shrinks to less than this fraction of the side's has vanished.
inline constexpr double kSmallestShrinkage = 1e-9;

/// Precondition: the chord is not zero.
OffsetArc place(const PixelArc& arc, const Vec2& tail);

/// Returns the unit tangents at the ends.
Vec2 tail_tangent(const OffsetArc& arc);
Vec2 head_tangent(const OffsetArc& arc);

/// Returns the radius of the offset to the left over the radius of the arc: 0 or less where the
/// arc's center is no farther away than the distance.
inline double shrinkage(const OffsetArc& arc, double distance) {
    return 1.0 - arc.curvature * distance;
}

/// Returns the arc at a distance to the left. Precondition: its shrinkage is positive.
OffsetArc offset_left(const OffsetArc& arc, double distance);

/// Returns the offset of a corner between two sides that turns right: the circle around the corner,
/// from the offset of the first side to that of the second.
OffsetArc corner_arc(const OffsetArc& before, const OffsetArc& after, double distance);

/// Returns the point with a parameter.
Vec2 point_at(const OffsetArc& arc, double parameter);

/// Returns the piece between two parameters, from < to, whose ends are known to differ by `chord`.
PixelArc piece(const OffsetArc& arc, double from, double to, const Vec2& chord);

/// Parameters at which an arc, extended to its whole circle, crosses the whole circle of another:
/// to the other's right side and to its left. Infinite or NaN where there is no such crossing.
struct Crossings {
    double leaving;
    double entering;
};
Crossings crossings(const OffsetArc& arc, const OffsetArc& other);

/// Returns the distance of a point from the nearest point of the arc.
double distance(const OffsetArc& arc, const Vec2& point);

/// Returns the radius of the smallest disc around the middle that holds the arc.
double extent(const OffsetArc& arc);

/// Returns the signed distance of the point middle + (x, y) to the left of the whole circle of an
/// arc with this unit tangent in its middle. Arguments are numbers, so that loops over points are
/// vectorized.
///
/// With f = n (x, y) - k / 2 (x² + y²), which is 0 on the circle and has a slope of 1 there,
/// 1 - 2 k f is the squared distance from the center over the squared radius.
[[gnu::always_inline]] inline double distance_left(
    double along_x, double along_y, double curvature, double x, double y) {
    const double f = along_x * y - along_y * x - 0.5 * curvature * (x * x + y * y);
    const double squared = 1.0 - 2.0 * curvature * f;
    return 2.0 * f / (1.0 + std::sqrt(squared > 0.0 ? squared : 0.0));
}

}  // namespace foam::texgen
