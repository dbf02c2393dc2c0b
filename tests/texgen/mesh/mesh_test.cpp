// SPDX-License-Identifier: Apache-2.0

#include "texgen/mesh/mesh.h"

#include <gtest/gtest.h>

#include <utility>

namespace foam::texgen {
namespace {

// The corner of a cube, cut off: a right tetrahedron with three edges of length 3.
Mesh tetrahedron() {
    return {{{0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {0, 0, 3}},
            {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
}

TEST(Mesh, ATetrahedronHasItsVolumeAtAnyPosition) {
    EXPECT_DOUBLE_EQ(volume(tetrahedron()), 4.5);
    // The volume does not depend on the position.
    Mesh moved = tetrahedron();
    for (Point3& point : moved.positions) {
        point[2] += 10.0F;
    }
    EXPECT_DOUBLE_EQ(volume(moved), 4.5);
}

TEST(Mesh, IsClosedOnlyIfEveryEdgeHasTwoTrianglesOfOneOrientation) {
    EXPECT_TRUE(is_closed(tetrahedron()));
    Mesh open = tetrahedron();
    open.triangles.pop_back();
    EXPECT_FALSE(is_closed(open));
    Mesh flipped = tetrahedron();
    std::swap(flipped.triangles[0][0], flipped.triangles[0][1]);
    EXPECT_FALSE(is_closed(flipped));
    Mesh doubled = tetrahedron();
    doubled.triangles.push_back({1, 2, 3});
    EXPECT_FALSE(is_closed(doubled));
}

// The triangle (1, 2, 3) has the normal (1, 1, 1) / sqrt(3) and the area 9 sqrt(3) / 2.
TEST(Mesh, AreaVectorsPointOut) {
    const Mesh mesh = tetrahedron();
    EXPECT_EQ(area_vector(mesh, mesh.triangles[3]), (std::array<double, 3>{9.0, 9.0, 9.0}));
    EXPECT_EQ(area_vector(mesh, mesh.triangles[0]), (std::array<double, 3>{0.0, 0.0, -9.0}));
    EXPECT_EQ(normalized({0.0, 3.0, 4.0}), (std::array<double, 3>{0.0, 0.6, 0.8}));
    EXPECT_EQ(normalized({0.0, 0.0, 0.0}), (std::array<double, 3>{0.0, 0.0, 0.0}));
}

}  // namespace
}  // namespace foam::texgen
