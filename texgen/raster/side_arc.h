#pragma once

#include "texgen/raster/arcs/pixel_arc.h"

#include <cmath>
#include <optional>

namespace foam::texgen {

/// One side of a bubble, or of the inset of one, placed in the plane (pixels), the bubble on its
/// left.
///
/// A point of it has the parameter s = 2 r tan(phi / 2), phi being the angle turned since the
/// middle and r the radius: finite on every arc, the arc length itself on a straight one, and
/// rational in the coordinates, so that nothing here divides by a curvature.
struct SideArc {
    Vec2 tail{0.0, 0.0};
    Vec2 head{0.0, 0.0};
    Vec2 tail_tangent{0.0, 0.0};  // unit vectors
    Vec2 head_tangent{0.0, 0.0};
    Vec2 middle{0.0, 0.0};
    Vec2 direction{0.0, 0.0};  // tangent in the middle
    double curvature = 0.0;    // 1 / pixels, positive where the arc turns left
    double cosine = 1.0;       // of its half angle
    double reach = 0.0;        // parameter of the head; that of the tail is -reach
    double extent = 0.0;       // radius of the disc around the middle that just holds the arc
};

/// A radius that shrinks to less than this part of itself counts as gone.
inline constexpr double kSmallestShrinkage = 1e-9;

/// Precondition: the chord is not zero.
SideArc place(const PixelArc& arc, const Vec2& tail);

/// The arc at a distance to the left; nothing if the arc's centre is nearer than that.
std::optional<SideArc> offset_left(const SideArc& arc, double distance);

/// The offset of the corner between two sides that turns right: the circle around the corner, from
/// the offset of the one to that of the other.
SideArc corner_arc(const SideArc& before, const SideArc& after, double distance);

/// Parameters at which an arc, extended to its whole circle, crosses that of another: to its right
/// side and to its left. Infinite or NaN where there is no such crossing.
struct Crossings {
    double leaving;
    double entering;
};
Crossings crossings(const SideArc& arc, const SideArc& other);

/// The whole circle of an arc, by its middle, and the unit tangent there.
struct ArcCircle {
    double x;
    double y;
    double along_x;
    double along_y;
    double curvature;
};

/// With y(s) = s / (1 + (k s / 2)²) (t + (k s / 2) n) the points of the one circle, relative to its
/// middle, the equation of the other, n' (y - q) - k' / 2 |y - q|² = 0, becomes a s² + b s - e = 0,
/// of which each root is in the form that does not cancel. No branches: several are found at once.
[[gnu::always_inline]] inline Crossings crossings(const ArcCircle& arc, const ArcCircle& other) {
    const double qx = other.x - arc.x;
    const double qy = other.y - arc.y;
    const double mx = other.curvature * qx - other.along_y;
    const double my = other.curvature * qy + other.along_x;
    const double e =
        other.along_x * qy - other.along_y * qx + 0.5 * other.curvature * (qx * qx + qy * qy);
    const double b = mx * arc.along_x + my * arc.along_y;
    const double across = my * arc.along_x - mx * arc.along_y;
    const double a =
        0.5 * (arc.curvature * across - other.curvature) - 0.25 * e * arc.curvature * arc.curvature;
    const double slope = std::sqrt(b * b + 4.0 * a * e);  // minus it at the one, plus at the other
    return {(b <= 0.0 ? -2.0 * e : -(b + slope)) / (b <= 0.0 ? slope - b : 2.0 * a),
            (b >= 0.0 ? 2.0 * e : slope - b) / (b >= 0.0 ? b + slope : 2.0 * a)};
}

Vec2 point_at(const SideArc& arc, double parameter);

/// The piece between two parameters, from < to.
PixelArc piece(const SideArc& arc, double from, double to);

/// From a point to the nearest point of the arc.
double distance(const SideArc& arc, const Vec2& point);

}  // namespace foam::texgen
