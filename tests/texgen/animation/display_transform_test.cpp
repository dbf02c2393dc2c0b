// SPDX-License-Identifier: Apache-2.0

#include "texgen/animation/display_transform.h"

#include "core/dynamics/shear.h"
#include "core/foam/honeycomb.h"

#include <gtest/gtest.h>

namespace foam::texgen {
namespace {

TEST(DisplayTransform, OnlyShearAndDriftHaveOne) {
    EXPECT_FALSE(has_display_transform({.kind = LoopKind::Breathe}));
    EXPECT_TRUE(has_display_transform({.kind = LoopKind::Shear}));
    EXPECT_TRUE(has_display_transform({.kind = LoopKind::Breathe, .drift = {0, 1}}));
}

// A quarter of a loop of two widths to the right and one height down.
TEST(DisplayTransform, DriftIsInPartsOfTheTorus) {
    const Foam foam = honeycomb(4, 4);
    const LoopOptions loop{.kind = LoopKind::Drift, .drift = {2, -1}};
    const Vec2 displacement(0.5 * foam.domain.width, -0.25 * foam.domain.height);
    const Vec2 point(0.3, 0.4);
    EXPECT_LT(
        (transformed_for_display(point, foam.domain, loop, 0.25) - (point + displacement)).norm(),
        1e-12);
    const Foam moved = transformed_for_display(foam, loop, 0.25);
    for (const JunctionId junction : foam.network.junctions()) {
        const Vec2 off = moved.positions[junction] - foam.positions[junction] - displacement;
        EXPECT_LT(foam.domain.nearest_copy(off).norm(), 1e-12);
    }
}

// A strain of 0.2 shifts a point by 0.2 of its height; the transform undoes this.
TEST(DisplayTransform, AShearIsTakenBack) {
    Foam foam = honeycomb(4, 4);
    const Foam unsheared = foam;
    shear(foam, 0.2);
    const LoopOptions loop{.kind = LoopKind::Shear};
    const Foam back = transformed_for_display(foam, loop, 0.5);
    EXPECT_EQ(back.domain.shear, 0.0);
    for (const JunctionId junction : foam.network.junctions()) {
        const Vec2 off = back.positions[junction] - unsheared.positions[junction];
        EXPECT_LT(unsheared.domain.nearest_copy(off).norm(), 1e-12);
    }
    const Vec2 point(0.3, 2.0);
    EXPECT_LT(
        (transformed_for_display(point, foam.domain, loop, 0.5) - Vec2(0.3 - 0.4, 2.0)).norm(),
        1e-12);
}

}  // namespace
}  // namespace foam::texgen
