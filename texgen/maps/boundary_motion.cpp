// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/boundary_motion.h"

#include <cmath>
#include <cstddef>

namespace foam::texgen {

// Mean value coordinates (Floater 2003, Hormann and Floater 2006): the motion of the point is a
// weighted mean of the motions of the corners. A corner at the distance r from the point has the
// weight (tan(a / 2) + tan(b / 2)) / r, where a and b are the signed angles that the two sides at
// the corner subtend at the point. The loop visits the sides, and adds the term of each side,
// tan(a / 2) / r, to the weights of both its ends. A point on a corner or a side is handled
// separately, because weights are infinite there.
Vec2 motion_at(const BoundaryMotion& boundary, const Vec2& point) {
    Vec2 sum = Vec2::Zero();
    double weights = 0.0;
    std::size_t k = boundary.points.size() - 1;
    Vec2 from = boundary.points[k] - point;
    double from_length = from.norm();
    for (std::size_t next = 0; next < boundary.points.size(); k = next++) {
        const Vec2 to = boundary.points[next] - point;
        const double to_length = to.norm();
        if (to_length == 0.0) {
            return boundary.motions[next];
        }
        const double twice_area = cross(from, to);
        const double lengths = from_length * to_length;
        if (twice_area == 0.0 && from.dot(to) < 0.0) {  // the point is on this side
            return (to_length * boundary.motions[k] + from_length * boundary.motions[next]) /
                   (from_length + to_length);
        }
        if (twice_area != 0.0) {
            const double tangent = (lengths - from.dot(to)) / twice_area;  // tan(angle / 2)
            sum += tangent / from_length * boundary.motions[k] +
                   tangent / to_length * boundary.motions[next];
            weights += tangent / from_length + tangent / to_length;
        }
        from = to;
        from_length = to_length;
    }
    return weights != 0.0 ? Vec2(sum / weights) : Vec2(Vec2::Zero());
}

}  // namespace foam::texgen
