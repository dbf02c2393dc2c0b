// SPDX-License-Identifier: Apache-2.0

#include "core/dynamics/restore_rafts.h"

#include "core/dynamics/step.h"
#include "core/foam/measure.h"
#include "core/foam/patch.h"
#include "tests/core/patches.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace foam {
namespace {

// Rotates the junctions around the origin by an angle in radians, then translates them.
void move(Foam& foam, double angle, const Vec2& by) {
    for (const JunctionId junction : foam.network.junctions()) {
        const Vec2 at = foam.positions[junction];
        foam.positions[junction] = by + std::cos(angle) * at + std::sin(angle) * turned_left(at);
    }
}

Foam equilibrated(Foam foam) {
    EXPECT_TRUE(equilibrate(foam, {}).converged());
    return foam;
}

TEST(RestoreRafts, CentersAreMeansOfArcs) {
    const Foam foam = equilibrated(test::double_bubble(1.0, 1.0));
    // Derived by hand, with the radius r of the outer arcs: an outer arc spans 240 degrees, and the
    // mean of its points is at the distance (sin 120 / (2 pi / 3)) r from the center of its circle.
    // The film between the bubbles is a chord of length sqrt(3) r at the distance r / 2 from this
    // center, on the opposite side.
    const std::map<BubbleIdentity, Vec2> centers = bubble_centers(foam);
    const double area = 2.0 * std::numbers::pi / 3.0 + std::numbers::sqrt3 / 4.0;
    const double r = 1.0 / std::sqrt(area);
    const double arc = 4.0 * std::numbers::pi / 3.0 * r;
    const double film = std::numbers::sqrt3 * r;
    const double of_arc = 0.5 * r + 0.5 * std::numbers::sqrt3 / (2.0 * std::numbers::pi / 3.0) * r;
    const double from_film = arc * of_arc / (arc + film);
    EXPECT_NEAR((centers.at(0) - centers.at(1)).norm(), 2.0 * from_film, 1e-9);
}

TEST(RestoreRafts, UndoesMotionExactly) {
    for (const Foam& foam : {equilibrated(test::double_bubble(1.0, 2.0)),
                             equilibrated(test::flower(1.0)),
                             equilibrated(test::chain())}) {
        for (const double angle : {0.0, 1e-3, 2.5, -3.0}) {
            Foam moved = foam;
            move(moved, angle, {30.0, -7.0});
            restore_rafts(moved, bubble_centers(foam));
            for (const JunctionId junction : foam.network.junctions()) {
                EXPECT_NEAR(
                    (moved.positions[junction] - foam.positions[junction]).norm(), 0.0, 1e-12);
            }
        }
    }
}

// The raft and the circle return to their own positions.
TEST(RestoreRafts, MovesEachRaftSeparately) {
    Foam foam = equilibrated(test::double_bubble(1.0, 2.0));
    foam.lone_bubbles.push_back({9, {4.0, 0.0}, 1.0});
    const std::map<BubbleIdentity, Vec2> before = bubble_centers(foam);
    Foam moved = foam;
    move(moved, 0.4, {0.0, 5.0});
    moved.lone_bubbles[0].center = {-3.0, 2.0};
    restore_rafts(moved, before);
    EXPECT_NEAR(
        (moved.positions[JunctionId{0}] - foam.positions[JunctionId{0}]).norm(), 0.0, 1e-13);
    EXPECT_EQ(moved.lone_bubbles[0].center, Vec2(4.0, 0.0));
}

// Returns the mean of the centers of all bubbles.
Vec2 middle_of(const Foam& foam) {
    Vec2 sum = Vec2::Zero();
    for (const auto& [bubble, center] : bubble_centers(foam)) {
        sum += center;
    }
    return sum / static_cast<double>(bubble_centers(foam).size());
}

// Returns the angle, in radians, by which the remaining bubbles have turned around their mean
// center.
double turn_since(const std::map<BubbleIdentity, Vec2>& before, const Foam& foam) {
    const Vec2 middle = middle_of(foam);
    double along = 0.0;
    double across = 0.0;
    for (const auto& [bubble, now] : bubble_centers(foam)) {
        along += (now - middle).dot(before.at(bubble) - middle);
        across += cross(before.at(bubble) - middle, now - middle);
    }
    return std::abs(std::atan2(across, along));
}

// The raft coarsens from 60 bubbles to a few, through T1s and T2s. The bubbles that are left are
// where the raft was, and each stays on its side of the raft. Without restore_rafts, such rafts
// turn by up to 0.8 in a step.
TEST(RestoreRafts, ACoarseningRaftKeepsItsPosition) {
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        PatchOptions options;
        options.bubbles = 60;
        options.seed = seed;
        Foam foam = equilibrated(seed_patch(disc_outline(), options));
        const Vec2 first = middle_of(foam);
        StepOptions step_options;
        step_options.coarsening.kappa = 0.02;
        for (int k = 0; k < 400 && foam.network.bubble_count() > 12; ++k) {
            const std::map<BubbleIdentity, Vec2> before = bubble_centers(foam);
            ASSERT_TRUE(step(foam, 0.5, step_options).equilibrium.converged());
            EXPECT_LT(turn_since(before, foam), 0.1) << seed << ' ' << k;
        }
        EXPECT_LE(foam.network.bubble_count(), 12U);
        EXPECT_LT((middle_of(foam) - first).norm(), 1.2) << seed;
    }
}

}  // namespace
}  // namespace foam
