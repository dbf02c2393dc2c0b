// SPDX-License-Identifier: Apache-2.0

#include "core/foam/corners.h"

#include <limits>

namespace foam {

std::vector<Vec2> corners_of(const Foam& foam, BubbleId bubble) {
    std::vector<Vec2> corners;
    Vec2 corner = foam.positions[foam.network.tail(foam.network.first(bubble))];
    for (const HalfEdgeId h : foam.network.around(bubble)) {
        corners.push_back(corner);
        corner += chord(foam, h);
    }
    return corners;
}

Vec2 mean_corner(const Foam& foam, BubbleId bubble) {
    Vec2 sum = Vec2::Zero();
    const std::vector<Vec2> corners = corners_of(foam, bubble);
    for (const Vec2& corner : corners) {
        sum += corner;
    }
    return sum / static_cast<double>(corners.size());
}

Box box_around_junctions(const Foam& foam) {
    const Vec2 far = Vec2::Constant(std::numeric_limits<double>::infinity());
    Box box{far, -far};
    for (const JunctionId junction : foam.network.junctions()) {
        box.low = box.low.cwiseMin(foam.positions[junction]);
        box.high = box.high.cwiseMax(foam.positions[junction]);
    }
    return box;
}

}  // namespace foam
