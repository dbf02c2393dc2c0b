// SPDX-License-Identifier: Apache-2.0

#include "core/equilibrium/drift.h"

#include "core/foam/honeycomb.h"
#include "tests/core/foams.h"

#include <gtest/gtest.h>

namespace foam {
namespace {

constexpr double kRounding = 1e-14;

// Returns the largest distance, on the torus, of a junction from its earlier position.
double largest_motion(const Foam& foam, const Positions& before) {
    double largest = 0.0;
    for (const JunctionId junction : foam.network.junctions()) {
        const Vec2 motion = foam.positions[junction] - before[junction];
        largest = std::max(largest, foam.domain.nearest_copy(motion).norm());
    }
    return largest;
}

TEST(Drift, OfTheWholeFoamIsUndone) {
    // The last two translations move junctions across the border of the torus' cell.
    for (const Vec2& by : {Vec2(0.01, 0.0), Vec2(-0.2, 0.35), Vec2(1.5, -1.5)}) {
        Foam foam = honeycomb(4, 6);
        const Positions before = foam.positions;
        translate(foam, by);
        ASSERT_GT(largest_motion(foam, before), 0.005);
        undo_drift(foam, before);
        EXPECT_LT(largest_motion(foam, before), 4.0 * kRounding);
    }
}

// Most junctions have not moved, so that the median motion is zero and no bit of the foam changes.
TEST(Drift, IsZeroIfOnlySomeJunctionsMove) {
    Foam foam = honeycomb(4, 6);
    const Positions before = foam.positions;
    for (const HalfEdgeId h : foam.network.around(BubbleId{7})) {
        place_junction(foam, foam.network.tail(h), before[foam.network.tail(h)] + Vec2(0.1, 0.2));
    }
    const Foam moved = foam;
    undo_drift(foam, before);
    EXPECT_TRUE(test::are_same(foam, moved));
}

// A junction that has moved relative to the rest of the foam keeps this relative motion.
TEST(Drift, LeavesTheMotionAgainstTheRest) {
    Foam foam = honeycomb(4, 6);
    const Positions before = foam.positions;
    const JunctionId junction{11};
    place_junction(foam, junction, foam.positions[junction] + Vec2(0.05, -0.02));
    translate(foam, Vec2(0.3, 0.1));
    undo_drift(foam, before);
    const Vec2 motion = foam.domain.nearest_copy(foam.positions[junction] - before[junction]);
    EXPECT_LT((motion - Vec2(0.05, -0.02)).norm(), 4.0 * kRounding);
}

// The medians along x and along y are independent. A third of the junctions moves along x only, a
// third along y only, and a third along both.
TEST(Drift, IsTheMedianAlongEachAxis) {
    Foam foam = honeycomb(3, 2);  // 12 junctions
    const Positions before = foam.positions;
    int k = 0;
    for (const JunctionId junction : foam.network.junctions()) {
        const Vec2 by(k % 3 == 0 ? 0.0 : 0.1, k % 3 == 1 ? 0.0 : 0.1);
        place_junction(foam, junction, before[junction] + by);
        ++k;
    }
    ASSERT_EQ(k, 12);
    undo_drift(foam, before);
    k = 0;
    for (const JunctionId junction : foam.network.junctions()) {
        const Vec2 expected(k % 3 == 0 ? -0.1 : 0.0, k % 3 == 1 ? -0.1 : 0.0);
        const Vec2 motion = foam.domain.nearest_copy(foam.positions[junction] - before[junction]);
        EXPECT_LT((motion - expected).norm(), kRounding);
        ++k;
    }
}

TEST(Drift, IsZeroWithoutJunctions) {
    Foam foam;
    undo_drift(foam, {});
    EXPECT_EQ(foam.network.junction_count(), 0U);
}

}  // namespace
}  // namespace foam
