// SPDX-License-Identifier: Apache-2.0

#include "texgen/raster/outline/clip_arc.h"

#include <gtest/gtest.h>

#include <cmath>

namespace foam::texgen {
namespace {

// Clips a piece to a box of 10 x 10.
auto clipped_to_box(const MonotonePiece& piece) {
    return clipped(piece, Vec2(0.0, 0.0), Vec2(10.0, 10.0));
}

TEST(ClipArc, KeepsPartsInside) {
    const auto pieces = clipped_to_box({{1.0, 2.0}, {3.0, 7.0}, 0.3});
    ASSERT_EQ(pieces.size(), 1U);
    EXPECT_EQ(pieces[0].tail, Vec2(1.0, 2.0));
    EXPECT_EQ(pieces[0].head, Vec2(3.0, 7.0));
    EXPECT_NEAR(pieces[0].sine, 0.3, 1e-15);
}

TEST(ClipArc, DropsPartsAboveBelowAndOnTheRight) {
    EXPECT_TRUE(clipped_to_box({{1.0, 11.0}, {3.0, 17.0}, 0.3}).empty());
    EXPECT_TRUE(clipped_to_box({{1.0, -11.0}, {3.0, -7.0}, 0.3}).empty());
    EXPECT_TRUE(clipped_to_box({{11.0, 1.0}, {13.0, 7.0}, 0.3}).empty());
    EXPECT_TRUE(clipped_to_box({{13.0, 1.0}, {11.0, 7.0}, 0.3}).empty());
}

TEST(ClipArc, KeepsTheHeightsOfPartsOnTheLeft) {
    for (const double x : {-4.0, -2.0}) {
        const auto pieces = clipped_to_box({{-3.0, 1.0}, {x, 7.0}, 0.0});
        ASSERT_EQ(pieces.size(), 1U);
        EXPECT_EQ(pieces[0].tail, Vec2(0.0, 1.0));
        EXPECT_EQ(pieces[0].head, Vec2(0.0, 7.0));
    }
}

// The piece is a quarter of the circle of radius 20 around (-12, -8), from (8, -8) up to (-12, 12).
// It enters the box at y = 0 and leaves it at x = 0.
TEST(ClipArc, CutsACircleAtBorders) {
    const auto pieces = clipped_to_box({{8.0, -8.0}, {-12.0, 12.0}, std::sqrt(0.5)});
    const double x = std::sqrt(20.0 * 20.0 - 8.0 * 8.0) - 12.0;
    const double y = std::sqrt(20.0 * 20.0 - 12.0 * 12.0) - 8.0;
    ASSERT_EQ(pieces.size(), 2U);
    const auto& [inside, border] = std::pair(pieces[0], pieces[1]);
    EXPECT_NEAR((inside.tail - Vec2(x, 0.0)).norm(), 0.0, 1e-12);
    EXPECT_NEAR((inside.head - Vec2(0.0, y)).norm(), 0.0, 1e-12);
    EXPECT_NEAR(inside.sine, 0.5 * (inside.head - inside.tail).norm() / 20.0, 1e-12);
    EXPECT_NEAR((border.tail - Vec2(0.0, y)).norm(), 0.0, 1e-12);
    EXPECT_EQ(border.head, Vec2(0.0, 10.0));
    EXPECT_EQ(border.sine, 0.0);
}

}  // namespace
}  // namespace foam::texgen
