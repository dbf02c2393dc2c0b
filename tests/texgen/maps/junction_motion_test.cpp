// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/junction_motion.h"

#include "core/foam/honeycomb.h"
#include "tests/support/sample_foams.h"

#include <gtest/gtest.h>

namespace foam::texgen {
namespace {

// Junctions whose bubbles do not meet in the next frame get the motion of the junctions around
// them.
TEST(JunctionMotion, LostJunctionsMoveAsThoseAround) {
    Foam foam = honeycomb(4, 4);
    const Frame frame = snapshot(foam, 1);
    for (const JunctionId junction : foam.network.junctions()) {
        place_junction(foam, junction, foam.positions[junction] + Vec2(0.1, 0.0));
    }
    Frame next = snapshot(foam, 2);
    next.bubbles[BubbleId{5}].identity = 99;  // so that its six junctions are not found
    for (const Vec2& motion : junction_motion(frame, next)) {
        EXPECT_NEAR(motion.x(), 0.1, 1e-12);
        EXPECT_NEAR(motion.y(), 0.0, 1e-12);
    }
}

// A junction is identified by its bubbles, so each one has its own motion.
TEST(JunctionMotion, AJunctionMovesToItsNextPosition) {
    Foam foam = honeycomb(4, 4);
    const Frame frame = snapshot(foam, 1);
    const JunctionId moved = *foam.network.junctions().begin();
    place_junction(foam, moved, foam.positions[moved] + Vec2(0.05, -0.02));
    const auto motions = junction_motion(frame, snapshot(foam, 2));
    for (const JunctionId junction : frame.network.junctions()) {
        const Vec2 expected = junction == moved ? Vec2(0.05, -0.02) : Vec2(0.0, 0.0);
        EXPECT_LT((motions[junction] - expected).norm(), 1e-12);
    }
}

}  // namespace
}  // namespace foam::texgen
