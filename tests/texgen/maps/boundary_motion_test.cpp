// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/boundary_motion.h"

#include <gtest/gtest.h>

namespace foam::texgen {
namespace {

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
    l_shape.motions[1] = Vec2(7.0, 7.0);
    EXPECT_EQ(motion_at(l_shape, l_shape.points[1]), l_shape.motions[1]);
    EXPECT_LT((motion_at(l_shape, {3.0, 0.0}) -
               Vec2(0.25 * l_shape.motions[0] + 0.75 * l_shape.motions[1]))
                  .norm(),
              1e-12);
}

}  // namespace
}  // namespace foam::texgen
