// SPDX-License-Identifier: Apache-2.0

#include "texgen/animation/shared_bubbles.h"

#include "core/dynamics/step.h"
#include "tests/support/sample_foams.h"
#include "texgen/animation/displaced_frame.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <vector>

namespace foam::texgen {
namespace {

constexpr int kBubbles = 60;

const Foam& foam_before() {
    static const Foam foam = foam::test::polydisperse_foam(kBubbles, 3);
    return foam;
}

// The foam of foam_before after gas has diffused for some time, moved by half a unit.
Frame frame_after(double time) {
    Foam foam = foam_before();
    EXPECT_TRUE(step(foam, time, {}).equilibrium.converged());
    translate(foam, {0.5, 0.0});
    return snapshot(foam, 1);
}

TEST(SharedBubbles, AMovedFoamIsShared) {
    Foam foam = foam_before();
    translate(foam, {0.4, -0.3});
    const Frame from = snapshot(foam_before(), 1);
    const Frame to = snapshot(foam, 1);
    for (const std::optional<Vec2>& by : displacements_of_shared(from, to)) {
        ASSERT_TRUE(by);
        EXPECT_LT((*by - Vec2(0.4, -0.3)).norm(), 1e-12);
    }
    const Frame half = moved_toward(from, to, 0.5);
    for (const JunctionId junction : from.network.junctions()) {
        const Vec2 off = half.positions[junction] - from.positions[junction] - Vec2(0.2, -0.15);
        EXPECT_LT(from.domain.nearest_copy(off).norm(), 1e-12);
    }
    for (const FilmId film : from.network.films()) {
        EXPECT_LT((half.arcs[film].chord - from.arcs[film].chord).norm(), 1e-12);
        EXPECT_NEAR(half.arcs[film].half_angle, from.arcs[film].half_angle, 1e-12);
    }
}

TEST(SharedBubbles, OthersAndDistantOnesAreNotShared) {
    const Frame from = snapshot(foam_before(), 1);
    const Frame after = frame_after(20.0);
    ASSERT_LT(after.bubbles.size(), from.bubbles.size());
    const std::vector<std::optional<Vec2>> shared = displacements_of_shared(from, after);
    const auto others = std::ranges::count_if(shared, [](const auto& by) { return !by; });
    EXPECT_GT(others, 0);
    EXPECT_LT(others, kBubbles / 2);
    Foam foam = foam_before();
    translate(foam, {3.0, 0.0});
    for (const std::optional<Vec2>& by : displacements_of_shared(from, snapshot(foam, 1))) {
        EXPECT_FALSE(by);
    }
}

// The centers of shared bubbles of both foams are nearer to each other after the move. They do not
// meet exactly, because a junction moves with all its bubbles.
TEST(SharedBubbles, FoamsMoveTogether) {
    const Frame from = snapshot(foam_before(), 1);
    const Frame to = frame_after(3.0);
    const Frame one = moved_toward(from, to, 0.3);
    const Frame other = moved_toward(to, from, 0.7);
    EXPECT_EQ(moved_toward(from, to, 0.0).positions, from.positions);
    const auto mean_distance = [](const Frame& a, const Frame& b) {
        double sum = 0.0;
        int count = 0;
        for (const std::optional<Vec2>& by : displacements_of_shared(a, b)) {
            sum += by ? by->norm() : 0.0;
            count += by ? 1 : 0;
        }
        return sum / count;
    };
    EXPECT_GT(mean_distance(from, to), 0.4);
    EXPECT_LT(mean_distance(one, other), 0.1);
}

}  // namespace
}  // namespace foam::texgen
