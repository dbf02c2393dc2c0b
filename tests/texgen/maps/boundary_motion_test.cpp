// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/boundary_motion.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

namespace foam::texgen {
namespace {

Vec2 motion_at(const BoundaryMotion& boundary, const Vec2& point) {
    MovingPoints points{{point.x()}, {point.y()}, {}, {}};
    set_motions(boundary, points);
    return {points.motion_x[0], points.motion_y[0]};
}

TEST(BoundaryMotion, IsExactOnThePolygonAndKeepsLinearMotion) {
    BoundaryMotion l_shape{
        {{0.0, 0.0}, {4.0, 0.0}, {4.0, 2.0}, {2.0, 2.0}, {2.0, 4.0}, {0.0, 4.0}}};
    const auto linear = [](const Vec2& p) {
        return Vec2(0.5 * p.x() - p.y() + 1.0, 2.0 * p.x() + 0.25 * p.y());
    };
    for (const Vec2& point : l_shape.points) {
        l_shape.motions.push_back(linear(point));
    }
    for (const Vec2& point : {Vec2(1.0, 1.0), Vec2(3.5, 0.3), Vec2(0.2, 3.9), Vec2(2.0, 0.0)}) {
        EXPECT_LT((motion_at(l_shape, point) - linear(point)).norm(), 1e-12);
    }
    // The points lead from one side of the boundary across a corner to another side.
    MovingPoints points{{0.0, 1.0, 2.0, 3.0, 4.0}, std::vector<double>(5, 2.0), {}, {}};
    set_motions(l_shape, points);
    for (std::size_t k = 0; k < 5; ++k) {
        const Vec2 motion(points.motion_x[k], points.motion_y[k]);
        EXPECT_LT((motion - linear({points.x[k], 2.0})).norm(), 1e-12) << k;
    }
    l_shape.motions[1] = Vec2(7.0, 7.0);
    EXPECT_EQ(motion_at(l_shape, l_shape.points[1]), l_shape.motions[1]);
    EXPECT_LT((motion_at(l_shape, {3.0, 0.0}) -
               Vec2(0.25 * l_shape.motions[0] + 0.75 * l_shape.motions[1]))
                  .norm(),
              1e-12);
}

}  // namespace
}  // namespace foam::texgen
