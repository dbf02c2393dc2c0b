// SPDX-License-Identifier: Apache-2.0

#include "core/foam/corners.h"

namespace foam {

std::vector<Vec2> corners_of(const Foam& foam, BubbleId bubble) {
    std::vector<Vec2> corners;
    Vec2 at = foam.positions[foam.network.tail(foam.network.first(bubble))];
    for (const HalfEdgeId h : foam.network.around(bubble)) {
        corners.push_back(at);
        at += chord(foam, h);
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

}  // namespace foam
