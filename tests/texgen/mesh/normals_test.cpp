// SPDX-License-Identifier: Apache-2.0

#include "texgen/mesh/normals.h"

#include "texgen/mesh/extrusion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace foam::texgen {
namespace {

// Two triangles that share the edge between the points 0 and 1 and form a roof: the normals of both
// sides are tilted by `angle` from the vertical.
Mesh roof(double angle) {
    const auto x = static_cast<float>(std::cos(angle));
    const auto z = static_cast<float>(-std::sin(angle));
    return {{{0, 0, 0}, {0, 1, 0}, {x, 0, z}, {-x, 0, z}}, {{0, 2, 1}, {0, 1, 3}}};
}

TEST(Normals, SharpEdgesHaveTwoPointsPerCorner) {
    const MeshWithNormals sharp = with_normals(roof(0.5));
    EXPECT_EQ(sharp.positions.size(), 6U);
    EXPECT_EQ(sharp.normals.size(), 6U);
    const std::uint32_t corner = sharp.triangles[0][0];
    EXPECT_NEAR(sharp.normals[corner][0], std::sin(0.5), 1e-6);
    EXPECT_NEAR(sharp.normals[corner][2], std::cos(0.5), 1e-6);
}

// 2 x 0.25 radians are less than 30 degrees. The mean of the normals is vertical.
TEST(Normals, FlatEdgesAreSmooth) {
    const MeshWithNormals smooth = with_normals(roof(0.25));
    EXPECT_EQ(smooth.positions.size(), 4U);
    EXPECT_EQ(smooth.triangles[0][0], smooth.triangles[1][0]);
    const std::uint32_t corner = smooth.triangles[0][0];
    EXPECT_NEAR(smooth.normals[corner][0], 0.0, 1e-6);
    EXPECT_NEAR(smooth.normals[corner][2], 1.0, 1e-6);
}

TEST(Normals, TrianglesKeepTheirPositions) {
    const Mesh mesh = roof(1.0);
    const MeshWithNormals result = with_normals(mesh);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k) {
            EXPECT_EQ(result.positions[result.triangles[t][k]],
                      mesh.positions[mesh.triangles[t][k]]);
        }
    }
}

// The tessellator makes triangles without area of the points on the edge from (3, 0) to (3, 3): two
// in each horizontal face.
TEST(Normals, TrianglesWithoutAreaHaveNormals) {
    const Ring ring{{0, 0}, {3, 0}, {3, 1}, {3, 2}, {3, 3}, {0, 3}, {0, 2}, {0, 1}};
    const Mesh mesh = extruded({.walls = {ring}, .wall_height = 1.0});
    EXPECT_EQ(std::ranges::count(mesh.triangles,
                                 std::array<double, 3>{},
                                 [&](const Triangle& one) { return area_vector(mesh, one); }),
              4);
    for (const auto& [x, y, z] : with_normals(mesh).normals) {
        EXPECT_EQ(x * x + y * y + z * z, 1.0F);
    }
}

}  // namespace
}  // namespace foam::texgen
