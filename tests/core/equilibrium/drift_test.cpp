// SPDX-License-Identifier: Apache-2.0

#include "core/equilibrium/drift.h"

#include "core/foam/honeycomb.h"
#include "core/foam/outline.h"
#include "core/foam/patch.h"
#include "core/geometry/elementary.h"
#include "tests/core/foams.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

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

// Two rafts that have moved and turned apart from each other return to their places. A junction of
// one raft that has moved against the rest of it keeps this motion.
TEST(Drift, OfEachRaftIsUndone) {
    const std::vector<Outline> squares = {outline_from_wkt("POLYGON((0 0, 1 0, 1 1, 0 1))"),
                                          outline_from_wkt("POLYGON((3 0, 4 0, 4 1, 3 1))")};
    PatchOptions options;
    options.bubbles = 60;
    Foam foam = seed_patch(squares, options);
    const Positions before = foam.positions;
    const auto [sine, cosine] = ieee::sincos(0.4);
    for (const JunctionId junction : foam.network.junctions()) {
        const Vec2 at = before[junction];
        const bool is_left = at.x() < 0.0;
        const Vec2 turned(cosine * at.x() - sine * at.y(), sine * at.x() + cosine * at.y());
        foam.positions[junction] = is_left ? at + Vec2(0.3, -2.0) : turned + Vec2(5.0, 1.0);
    }
    ASSERT_GT(largest_motion(foam, before), 2.0);
    const JunctionId moved = *foam.network.junctions().begin();
    foam.positions[moved] += Vec2(0.0, 0.05);
    undo_drift(foam, before);
    for (const JunctionId junction : foam.network.junctions()) {
        const Vec2 motion = foam.positions[junction] - before[junction];
        EXPECT_NEAR(motion.norm(), junction == moved ? 0.05 : 0.0, 1e-9);
    }
}

}  // namespace
}  // namespace foam
