#include "texgen/raster/outline/full_inset.h"

#include "tests/support/simd_levels.h"

#include <gtest/gtest.h>

namespace foam::texgen {
namespace {

std::vector<OffsetArc> polygon(const std::vector<Vec2>& corners, double half_angle = 0.0) {
    std::vector<OffsetArc> sides;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const Vec2 chord = corners[(k + 1) % corners.size()] - corners[k];
        sides.push_back(place(pixel_arc({chord, half_angle}), corners[k]));
    }
    return sides;
}

TEST(FullInset, OfARectangleIsARectangle) {
    at_every_simd_level([] {
        FullInset inset;
        ArcLoops loops;
        ASSERT_TRUE(inset.trace(polygon({{0, 0}, {9, 0}, {9, 5}, {0, 5}}), 1.0, loops));
        ASSERT_EQ(loops.loop_ends, std::vector<std::size_t>{4});
        const std::vector<Vec2> tails{{1, 1}, {8, 1}, {8, 4}, {1, 4}};
        for (std::size_t k = 0; k < tails.size(); ++k) {
            EXPECT_LT((loops.sides[k].tail - tails[k]).norm(), 1e-12);
            EXPECT_NEAR(loops.sides[k].arc.sine, 0.0, 1e-15);
        }
    });
}

// The offset of an arc of a hexagon keeps its center, so that the inset's corners are on the
// bisectors.
TEST(FullInset, KeepsTheCurvatureCentersOfASymmetricBubble) {
    std::vector<Vec2> corners;
    for (int k = 0; k < 6; ++k) {
        corners.emplace_back(10.0 * std::cos(k * 1.0471975511965976),
                             10.0 * std::sin(k * 1.0471975511965976));
    }
    FullInset inset;
    ArcLoops loops;
    ASSERT_TRUE(inset.trace(polygon(corners, 0.2), 1.0, loops));
    ASSERT_EQ(loops.sides.size(), 6U);
    for (std::size_t k = 0; k < 6; ++k) {
        EXPECT_NEAR(cross(loops.sides[k].tail, corners[k]), 0.0, 1e-9);
        EXPECT_LT(loops.sides[k].tail.norm(), 10.0);
    }
}

TEST(FullInset, IsNotProvenWhereASideDropsOut) {
    FullInset inset;
    ArcLoops loops;
    const auto cut_corner = polygon({{0, 0}, {10, 0}, {10, 9.5}, {9.5, 10}, {0, 10}});
    EXPECT_TRUE(inset.trace(cut_corner, 0.5, loops));
    loops = {};
    EXPECT_FALSE(inset.trace(cut_corner, 3.0, loops));
    EXPECT_FALSE(inset.trace(polygon({{0, 0}, {9, 0}, {9, 2}, {0, 2}}), 1.5, loops));
    EXPECT_FALSE(inset.trace(polygon({{0, 0}, {9, 0}}), 0.1, loops));  // two sides
    EXPECT_TRUE(loops.sides.empty());
    EXPECT_TRUE(loops.loop_ends.empty());
}

// An L of which the inner corner turns right: circles around it belong to the inset.
TEST(FullInset, IsNotProvenAtACornerThatTurnsRight) {
    FullInset inset;
    ArcLoops loops;
    EXPECT_FALSE(
        inset.trace(polygon({{0, 0}, {10, 0}, {10, 4}, {4, 4}, {4, 10}, {0, 10}}), 1.0, loops));
}

}  // namespace
}  // namespace foam::texgen
