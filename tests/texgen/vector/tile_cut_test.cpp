// SPDX-License-Identifier: Apache-2.0

#include "texgen/vector/tile_cut.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <numbers>

namespace foam::texgen {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr Domain kTorus{4.0, 3.0, 0.0};
constexpr Domain kSheared{4.0, 3.0, 1.0};

double area_of(const std::vector<Chain>& chains) {
    double area = 0.0;
    for (const Chain& chain : chains) {
        EXPECT_TRUE(chain.is_closed);
        area += signed_area(chain);
    }
    return area;
}

TEST(TileCut, AnArcInOneCellIsOnePieceWithTheSameHalfAngle) {
    const DrawnArc arc{{1.0, 1.0}, {2.0, 2.0}, 0.3};
    const auto pieces = cut_at_cells(arc, kTorus);
    ASSERT_EQ(pieces.size(), 1U);
    EXPECT_EQ(pieces[0].arc.half_angle, 0.3);
    EXPECT_EQ(pieces[0].arc.tail, arc.tail);
    EXPECT_EQ(pieces[0].arc.head, arc.head);
}

// Half a circle of radius 1 around (4, 1), from (3, 1) below the center to (5, 1), crosses the
// border x = 4 at (4, 0): exactly in a corner of the tile. A circle around (4, 1.5) crosses it at
// (4, 0.5), where it has turned by 90 degrees.
TEST(TileCut, AnArcIsCutExactlyAtTheBorder) {
    const auto pieces = cut_at_cells({{3.0, 1.5}, {5.0, 1.5}, 0.5 * kPi}, kTorus);
    ASSERT_EQ(pieces.size(), 2U);
    EXPECT_EQ(pieces[0].arc.head.x(), 4.0);
    EXPECT_EQ(pieces[1].arc.tail.x(), 0.0);
    EXPECT_EQ(pieces[0].arc.head.y(), pieces[1].arc.tail.y());
    EXPECT_NEAR(pieces[0].arc.head.y(), 0.5, 1e-15);
    EXPECT_NEAR(pieces[0].arc.half_angle, 0.25 * kPi, 1e-15);
    EXPECT_NEAR(pieces[1].arc.half_angle, 0.25 * kPi, 1e-15);
    EXPECT_EQ(pieces[1].cell, (LatticeOffset{1, 0}));
    EXPECT_EQ(pieces[1].arc.head, Vec2(1.0, 1.5));
}

// An arc that leaves the tile and returns has three pieces, although both ends are in the tile.
TEST(TileCut, AnArcThatBulgesOverTheBorderHasThreePieces) {
    const auto pieces = cut_at_cells({{3.5, 0.5}, {3.5, 2.5}, 0.5 * kPi}, kTorus);
    ASSERT_EQ(pieces.size(), 3U);
    EXPECT_EQ(pieces[1].cell, (LatticeOffset{1, 0}));
    // The circle has radius 1 and center (3.5, 1.5); it crosses x = 4 at 1.5 - sqrt(3) / 2.
    EXPECT_NEAR(pieces[0].arc.head.y(), 1.5 - std::sqrt(0.75), 1e-15);
    // The middle piece turns by 120 degrees.
    EXPECT_NEAR(pieces[1].arc.half_angle, kPi / 3.0, 1e-15);
}

TEST(TileCut, AStraightLineIsCutAtRowsAndColumns) {
    const auto pieces = cut_at_cells({{3.0, 2.5}, {6.0, 5.5}, 0.0}, kTorus);  // x = y + 0.5
    ASSERT_EQ(pieces.size(), 3U);
    EXPECT_EQ(pieces[0].cell, (LatticeOffset{0, 0}));
    EXPECT_EQ(pieces[1].cell, (LatticeOffset{0, 1}));
    EXPECT_EQ(pieces[2].cell, (LatticeOffset{1, 1}));
    EXPECT_EQ(pieces[1].arc.tail, Vec2(3.5, 0.0));
    EXPECT_EQ(pieces[1].arc.head, Vec2(4.0, 0.5));
}

// In the row above, cells of the sheared torus begin 1 further right.
TEST(TileCut, RowsOfAShearedTorusAreShifted) {
    const auto pieces = cut_at_cells({{3.5, 2.0}, {3.5, 4.0}, 0.0}, kSheared);
    ASSERT_EQ(pieces.size(), 2U);
    EXPECT_EQ(pieces[0].arc.head, Vec2(3.5, 3.0));
    EXPECT_EQ(pieces[1].arc.tail, Vec2(2.5, 0.0));
    const auto beyond = cut_at_cells({{4.5, 4.0}, {5.5, 4.0}, 0.0}, kSheared);
    ASSERT_EQ(beyond.size(), 2U);  // cut at x = 5
    EXPECT_EQ(beyond[1].cell, (LatticeOffset{1, 1}));
}

// A disk around a corner of the tile is four quarters of a disk. On the sheared torus, the corner
// is in the middle of the lower side of a cell, which contains the upper half of the disk.
TEST(TileCut, ADiskAroundACornerIsFourQuarters) {
    const auto quarters = closed_in_cells(circle({4.0, 3.0}, 1.0), kTorus);
    EXPECT_EQ(quarters.size(), 4U);
    EXPECT_NEAR(area_of(quarters), kPi, 1e-13);
    for (const Chain& part : quarters) {
        EXPECT_NEAR(signed_area(part), 0.25 * kPi, 1e-13);
    }
    const auto sheared = closed_in_cells(circle({4.0, 3.0}, 1.0), kSheared);
    EXPECT_EQ(sheared.size(), 3U);
    EXPECT_NEAR(area_of(sheared), kPi, 1e-13);
}

TEST(TileCut, ADiskInOneCellStaysWhole) {
    const auto parts = closed_in_cells(circle({6.0, 1.5}, 1.0), kTorus);
    ASSERT_EQ(parts.size(), 1U);
    EXPECT_NEAR(area_of(parts), kPi, 1e-13);
    EXPECT_NEAR((centroid(parts[0]) - Vec2(2.0, 1.5)).norm(), 0.0, 1e-13);
}

// A ring with radii 0.5 and 1 around a corner: the tile shows a quarter of it.
TEST(TileCut, ClippingKeepsHoles) {
    const auto ring = clipped_to_tile(
        {circle({0.0, 0.0}, 1.0), reversed(circle({0.0, 0.0}, 0.5))}, kTorus.width, kTorus.height);
    ASSERT_EQ(ring.size(), 1U);
    EXPECT_NEAR(area_of(ring), 0.25 * kPi * 0.75, 1e-13);
    const auto inside = clipped_to_tile(
        {circle({2.0, 1.5}, 1.0), reversed(circle({2.0, 1.5}, 0.5))}, kTorus.width, kTorus.height);
    EXPECT_EQ(inside.size(), 2U);
    EXPECT_NEAR(area_of(inside), kPi * 0.75, 1e-13);
}

// The arcs of a disk that contains the tile, or is beside it, are all outside of the tile. So are
// those of a hole beside the tile, or around it.
TEST(TileCut, ARegionMayContainTheTile) {
    const double area = kTorus.width * kTorus.height;
    const Chain around = circle({2.0, 1.5}, 10.0);
    const auto area_in_tile = [](const std::vector<Chain>& chains) {
        return area_of(clipped_to_tile(chains, kTorus.width, kTorus.height));
    };
    EXPECT_DOUBLE_EQ(area_in_tile({around}), area);
    EXPECT_DOUBLE_EQ(area_in_tile({around, reversed(circle({8.0, 1.5}, 2.0))}), area);
    EXPECT_NEAR(area_in_tile({around, reversed(circle({2.0, 1.5}, 1.0))}), area - kPi, 1e-13);
    EXPECT_EQ(area_in_tile({around, reversed(circle({2.0, 1.5}, 5.0))}), 0.0);
    for (const Vec2& center : {Vec2(-4.0, 1.5), Vec2(8.0, 1.5), Vec2(2.0, -4.0), Vec2(2.0, 7.0)}) {
        EXPECT_EQ(area_in_tile({circle(center, 3.5)}), 0.0);
    }
}

}  // namespace
}  // namespace foam::texgen
