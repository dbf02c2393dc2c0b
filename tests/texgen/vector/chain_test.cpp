// SPDX-License-Identifier: Apache-2.0

#include "texgen/vector/chain.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <numbers>

namespace foam::texgen {
namespace {

constexpr double kPi = std::numbers::pi;

Chain square() {
    return {{0.0, 0.0},
            {{{2.0, 0.0}, 0.0}, {{2.0, 2.0}, 0.0}, {{0.0, 2.0}, 0.0}, {{0.0, 0.0}, 0.0}},
            true};
}

TEST(Chain, ReversingASquareNegatesItsArea) {
    EXPECT_DOUBLE_EQ(signed_area(square()), 4.0);
    EXPECT_DOUBLE_EQ(signed_area(reversed(square())), -4.0);
}

TEST(Chain, ACircleHasItsAreaAndCentroid) {
    const Chain disk = circle({3.0, -1.0}, 2.0);
    EXPECT_NEAR(signed_area(disk), 4.0 * kPi, 1e-13);
    EXPECT_NEAR((centroid(disk) - Vec2(3.0, -1.0)).norm(), 0.0, 1e-13);
    EXPECT_NEAR((centroid(reversed(disk)) - Vec2(3.0, -1.0)).norm(), 0.0, 1e-13);
}

// The centroid of half a disk of radius r is 4 r / (3 pi) from the center.
TEST(Chain, HalfADiskHasAKnownCentroid) {
    const Chain half{{1.0, 0.0}, {{{-1.0, 0.0}, 0.5 * kPi}, {{1.0, 0.0}, 0.0}}, true};
    EXPECT_NEAR(centroid(half).x(), 0.0, 1e-14);
    EXPECT_NEAR(centroid(half).y(), 4.0 / (3.0 * kPi), 1e-14);
}

// A square whose right side bends inwards loses half a disk of radius 1. Its moment about x = 0 is
// 4 * 1 - pi/2 (2 - 4 / (3 pi)).
TEST(Chain, AnArcThatBendsInwardsMovesTheCentroid) {
    Chain bitten = square();
    bitten.steps[1].half_angle = -0.5 * kPi;
    EXPECT_NEAR(signed_area(bitten), 4.0 - 0.5 * kPi, 1e-14);
    const double moment = 4.0 - 0.5 * kPi * (2.0 - 4.0 / (3.0 * kPi));
    EXPECT_NEAR(centroid(bitten).x(), moment / (4.0 - 0.5 * kPi), 1e-14);
    EXPECT_NEAR(centroid(bitten).y(), 1.0, 1e-14);
}

NetArc line(Vec2 tail, Vec2 head, std::uint64_t from, std::uint64_t to) {
    return {{std::move(tail), std::move(head), 0.0}, from, to};
}

std::size_t arc_count(const std::vector<Chain>& chains) {
    std::size_t count = 0;
    for (const Chain& chain : chains) {
        count += chain.steps.size();
    }
    return count;
}

// Two of the three arms of a Y are one chain, the third arm is another.
TEST(Chain, ThreeArmsAreTwoChains) {
    const std::vector<NetArc> arms = {line({0.0, 0.0}, {0.0, 1.0}, 0, 1),
                                      line({0.0, 0.0}, {-1.0, -1.0}, 0, 2),
                                      line({1.0, -1.0}, {0.0, 0.0}, 3, 0)};
    const std::vector<Chain> chains = joined(arms);
    ASSERT_EQ(chains.size(), 2U);
    EXPECT_EQ(arc_count(chains), 3U);
    for (const Chain& chain : chains) {
        EXPECT_FALSE(chain.is_closed);
    }
}

TEST(Chain, ATriangleIsOneClosedChain) {
    const std::vector<NetArc> sides = {line({0.0, 0.0}, {1.0, 0.0}, 0, 1),
                                       line({0.0, 1.0}, {1.0, 0.0}, 2, 1),
                                       line({0.0, 1.0}, {0.0, 0.0}, 2, 0)};
    const std::vector<Chain> chains = joined(sides);
    ASSERT_EQ(chains.size(), 1U);
    EXPECT_TRUE(chains[0].is_closed);
    EXPECT_EQ(chains[0].steps.size(), 3U);
    EXPECT_DOUBLE_EQ(std::abs(signed_area(chains[0])), 0.5);
}

// An arc from a node to the same node is a closed chain of one arc.
TEST(Chain, ALoopOfOneArcIsClosed) {
    const std::vector<NetArc> loop = {line({0.0, 0.0}, {0.0, 0.0}, 7, 7)};
    const std::vector<Chain> chains = joined(loop);
    ASSERT_EQ(chains.size(), 1U);
    EXPECT_TRUE(chains[0].is_closed);
}

}  // namespace
}  // namespace foam::texgen
