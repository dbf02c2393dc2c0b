// SPDX-License-Identifier: Apache-2.0

#include "core/foam/corners.h"

#include "core/foam/honeycomb.h"

#include <gtest/gtest.h>

namespace foam {
namespace {

// Bubbles of the honeycomb that cross the border of the torus have corners outside of the
// fundamental cell, so that neighboring corners are never farther apart than a film is long.
TEST(Corners, AreUnwrapped) {
    const Foam foam = honeycomb(4, 4);
    for (const BubbleId bubble : foam.network.bubbles()) {
        const std::vector<Vec2> corners = corners_of(foam, bubble);
        const std::vector<HalfEdgeId> sides = foam.network.around(bubble);
        ASSERT_EQ(corners.size(), 6U);
        for (std::size_t k = 0; k < 6; ++k) {
            const Vec2& at = foam.positions[foam.network.tail(sides[k])];
            EXPECT_LT(foam.domain.nearest_copy(corners[k] - at).norm(), 1e-12);
            EXPECT_NEAR(
                (corners[(k + 1) % 6] - corners[k]).norm(), chord(foam, sides[k]).norm(), 1e-12);
        }
    }
}

// The mean of the corners of a hexagon is half-way between opposite corners.
TEST(Corners, TheMeanOfAHexagonIsItsCenter) {
    const Foam foam = honeycomb(4, 4);
    const std::vector<Vec2> corners = corners_of(foam, BubbleId{5});
    const Vec2 center = 0.5 * (corners[0] + corners[3]);
    EXPECT_LT((mean_corner(foam, BubbleId{5}) - center).norm(), 1e-12);
}

TEST(Corners, TheBoxIsTheSmallestAroundAllJunctions) {
    const Foam foam = honeycomb(4, 4);
    const Box box = box_around_junctions(foam);
    bool is_left = false;
    bool is_right = false;
    bool is_lower = false;
    bool is_upper = false;
    for (const JunctionId junction : foam.network.junctions()) {
        const Vec2& at = foam.positions[junction];
        EXPECT_TRUE((at.array() >= box.low.array()).all() &&
                    (at.array() <= box.high.array()).all());
        is_left = is_left || at.x() == box.low.x();
        is_right = is_right || at.x() == box.high.x();
        is_lower = is_lower || at.y() == box.low.y();
        is_upper = is_upper || at.y() == box.high.y();
    }
    EXPECT_TRUE(is_left && is_right && is_lower && is_upper);
}

}  // namespace
}  // namespace foam
