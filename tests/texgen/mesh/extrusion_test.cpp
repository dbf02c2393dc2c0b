// SPDX-License-Identifier: Apache-2.0

#include "texgen/mesh/extrusion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

namespace foam::texgen {
namespace {

Ring rectangle(const Vec2& low, const Vec2& high) {
    return {low, {high.x(), low.y()}, high, {low.x(), high.y()}};
}

Ring reversed(Ring ring) {
    std::ranges::reverse(ring);
    return ring;
}

// A frame of width 1 in a square of 10, without a plate.
TEST(Extrusion, AFrameWithoutAPlateIsClosed) {
    const Mesh mesh =
        extruded({.walls = {rectangle({0, 0}, {10, 10}), reversed(rectangle({1, 1}, {9, 9}))},
                  .wall_height = 3.0});
    EXPECT_TRUE(is_closed(mesh));
    EXPECT_DOUBLE_EQ(volume(mesh), (100.0 - 64.0) * 3.0);
    // 8 triangles on top and on the bottom, and 2 for each of 8 sides.
    EXPECT_EQ(mesh.triangles.size(), 32U);
}

// A plate of 12 x 12 that extends beyond the walls.
TEST(Extrusion, AFrameOnALargerPlateIsClosed) {
    const Mesh mesh =
        extruded({.walls = {rectangle({1, 1}, {11, 11}), reversed(rectangle({2, 2}, {10, 10}))},
                  .plate = {rectangle({0, 0}, {12, 12})},
                  .base_height = 2.0,
                  .wall_height = 3.0});
    EXPECT_TRUE(is_closed(mesh));
    EXPECT_DOUBLE_EQ(volume(mesh), 144.0 * 2.0 + 36.0 * 3.0);
}

// Walls that a tile cuts: a cross whose arms end at the border, and a wall along a part of the
// border around a corner.
TEST(Extrusion, WallsMayEndAtTheBorderOfThePlate) {
    const Ring cross{{4, 0},
                     {5, 0},
                     {5, 4},
                     {10, 4},
                     {10, 5},
                     {5, 5},
                     {5, 10},
                     {4, 10},
                     {4, 5},
                     {0, 5},
                     {0, 4},
                     {4, 4}};
    const Ring corner{{9, 10}, {9, 9}, {10, 9}, {10, 10}};
    const Extrusion extrusion{.walls = {cross, corner},
                              .plate = {rectangle({0, 0}, {10, 10})},
                              .reaches_border = true,
                              .base_height = 1.0,
                              .wall_height = 2.0};
    const Mesh mesh = extruded(extrusion);
    EXPECT_TRUE(is_closed(mesh));
    EXPECT_DOUBLE_EQ(volume(mesh), 100.0 + 2.0 * (19.0 + 1.0));
}

TEST(Extrusion, WallsThatCoverThePlateAreABox) {
    const Mesh mesh = extruded({.walls = {rectangle({0, 0}, {3, 2})},
                                .plate = {rectangle({0, 0}, {3, 2})},
                                .reaches_border = true,
                                .base_height = 1.0,
                                .wall_height = 1.0});
    EXPECT_TRUE(is_closed(mesh));
    EXPECT_DOUBLE_EQ(volume(mesh), 12.0);
}

TEST(Extrusion, APlateWithoutWallsIsFlat) {
    const Mesh mesh = extruded({.walls = {},
                                .plate = {rectangle({0, 0}, {3, 2})},
                                .reaches_border = true,
                                .base_height = 1.5,
                                .wall_height = 1.0});
    EXPECT_TRUE(is_closed(mesh));
    EXPECT_DOUBLE_EQ(volume(mesh), 9.0);
}

// Rings of a plate that cover each other are one plate.
TEST(Extrusion, OverlappingRingsOfAPlateAreOnePlate) {
    const Mesh mesh = extruded({.walls = {rectangle({1, 1}, {2, 2})},
                                .plate = {rectangle({0, 0}, {4, 4}), rectangle({3, 3}, {5, 5})},
                                .base_height = 1.0,
                                .wall_height = 1.0});
    EXPECT_TRUE(is_closed(mesh));
    EXPECT_DOUBLE_EQ(volume(mesh), 16.0 + 4.0 - 1.0 + 1.0);
}

// Two walls with a common corner would share a vertical edge of four rectangles.
TEST(Extrusion, WallsThatTouchInAPointAreRejected) {
    EXPECT_THROW(extruded({.walls = {rectangle({0, 0}, {1, 1}), rectangle({1, 1}, {2, 2})},
                           .wall_height = 1.0}),
                 std::invalid_argument);
}

}  // namespace
}  // namespace foam::texgen
