// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/boundary_motion.h"

#include "core/parallel/simd_level.h"
#include "texgen/raster/simd/kernel.h"

#include <cmath>
#include <cstddef>

namespace foam::texgen {

// Mean value coordinates (Floater 2003, Hormann and Floater 2006): the motion of a point is a
// weighted mean of the motions of the polygon's corners. Let r be the distance of a corner from the
// point. The two sides at the corner subtend the signed angles a and b at the point. The weight of
// the corner is (tan(a / 2) + tan(b / 2)) / r. The outer loop visits the sides. For all points, it
// adds the term of a side, tan(a / 2) / r, to the weights of both ends of the side. Weights are
// infinite at a point on a corner or a side, so these points are computed separately.

namespace {

// A side of the polygon and the motions of its ends.
struct Side {
    Vec2 from;
    Vec2 to;
    Vec2 from_motion;
    Vec2 to_motion;
};

// Calls visit(side) for all sides.
template <class Visit>
void for_each_side(const BoundaryMotion& boundary, const Visit& visit) {
    std::size_t k = boundary.points.size() - 1;
    for (std::size_t next = 0; next < boundary.points.size(); k = next++) {
        visit(Side{boundary.points[k],
                   boundary.points[next],
                   boundary.motions[k],
                   boundary.motions[next]});
    }
}

// The sum of weights for each point, and whether the point is on a side of the polygon.
struct Weights {
    explicit Weights(std::size_t count) : sums(count), is_on_side(count) {}

    std::vector<double> sums;
    std::vector<double> is_on_side;  // 1 or 0
};

// Adds the weights of the ends of a side, and their motions times these weights. A side adds no
// weights at points on the straight line through it. The motions of points on the side itself are
// replaced later (set_motions).
void add_side(const Side& side, MovingPoints& points, Weights& weights) {
    at_simd_level([side,
                   count = points.x.size(),
                   xs = points.x.data(),
                   ys = points.y.data(),
                   motion_x = points.motion_x.data(),
                   motion_y = points.motion_y.data(),
                   sums = weights.sums.data(),
                   is_on_side = weights.is_on_side.data()] {
        FOAM_INDEPENDENT_ITERATIONS
        for (std::size_t k = 0; k < count; ++k) {
            const double from_x = side.from.x() - xs[k];
            const double from_y = side.from.y() - ys[k];
            const double to_x = side.to.x() - xs[k];
            const double to_y = side.to.y() - ys[k];
            const double from_length = std::sqrt(from_x * from_x + from_y * from_y);
            const double to_length = std::sqrt(to_x * to_x + to_y * to_y);
            const double twice_area = from_x * to_y - from_y * to_x;
            const double dot = from_x * to_x + from_y * to_y;
            const double tangent = (from_length * to_length - dot) / twice_area;  // tan(angle / 2)
            const double from_weight = twice_area == 0.0 ? 0.0 : tangent / from_length;
            const double to_weight = twice_area == 0.0 ? 0.0 : tangent / to_length;
            motion_x[k] += from_weight * side.from_motion.x() + to_weight * side.to_motion.x();
            motion_y[k] += from_weight * side.from_motion.y() + to_weight * side.to_motion.y();
            sums[k] += from_weight + to_weight;
            is_on_side[k] = twice_area == 0.0 && dot <= 0.0 ? 1.0 : is_on_side[k];
        }
    });
}

// Returns the motion of a point on a side of the polygon, interpolated between the ends of the
// side. If several sides contain the point, as at a corner, the last one is used.
Vec2 motion_on_side(const BoundaryMotion& boundary, const Vec2& point) {
    Vec2 motion = Vec2::Zero();
    for_each_side(boundary, [&](const Side& side) {
        const Vec2 from = side.from - point;
        const Vec2 to = side.to - point;
        const double lengths = from.norm() + to.norm();
        if (cross(from, to) == 0.0 && from.dot(to) <= 0.0 && lengths > 0.0) {
            motion = (to.norm() * side.from_motion + from.norm() * side.to_motion) / lengths;
        }
    });
    return motion;
}

}  // namespace

void set_motions(const BoundaryMotion& boundary, MovingPoints& points) {
    points.motion_x.assign(points.x.size(), 0.0);
    points.motion_y.assign(points.x.size(), 0.0);
    Weights weights(points.x.size());
    for_each_side(boundary, [&](const Side& side) { add_side(side, points, weights); });
    for (std::size_t k = 0; k < points.x.size(); ++k) {
        const double sum = weights.sums[k];
        if (weights.is_on_side[k] > 0.0) {
            const Vec2 motion = motion_on_side(boundary, {points.x[k], points.y[k]});
            points.motion_x[k] = motion.x();
            points.motion_y[k] = motion.y();
        } else {
            points.motion_x[k] = sum != 0.0 ? points.motion_x[k] / sum : 0.0;
            points.motion_y[k] = sum != 0.0 ? points.motion_y[k] / sum : 0.0;
        }
    }
}

}  // namespace foam::texgen
