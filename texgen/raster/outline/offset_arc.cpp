// SPDX-License-Identifier: Apache-2.0

#include "texgen/raster/outline/offset_arc.h"

#include <algorithm>
#include <cmath>

namespace foam::texgen {

OffsetArc corner_arc(const OffsetArc& before, const OffsetArc& after, double distance) {
    const Vec2 from = head_tangent(before);
    const Vec2 to = tail_tangent(after);
    const Vec2 bisector = from + to;
    OffsetArc cap;
    cap.direction =
        bisector.norm() > 0.0 ? Vec2(bisector / bisector.norm()) : Vec2(-1.0 * turned_left(from));
    cap.middle = point_at(before, before.reach) + distance * turned_left(cap.direction);
    cap.curvature = -1.0 / distance;
    cap.cosine = 0.5 * bisector.norm();
    cap.sine = -0.5 * (to - from).norm();
    cap.reach = -2.0 * distance * cap.sine / (1.0 + cap.cosine);
    return cap;
}

// The point of the arc's circle that is nearest to the given point has the parameter (OffsetArc)
//     2 u / (2 - k v - k d).
// Here k is the curvature of the arc, and d is the signed distance of the given point from the
// circle. Relative to the middle of the arc, the given point has the coordinates u along the
// tangent and v along the normal. If the parameter is beyond an end of the arc, one of the ends is
// nearest.
double distance(const OffsetArc& arc, const Vec2& point) {
    const Vec2 y = point - arc.middle;
    const double u = arc.direction.dot(y);
    const double v = cross(arc.direction, y);
    const double left = distance_left(arc, point);
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
