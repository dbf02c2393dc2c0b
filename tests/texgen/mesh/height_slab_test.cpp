// SPDX-License-Identifier: Apache-2.0

#include "texgen/mesh/height_slab.h"

#include <gtest/gtest.h>

namespace foam::texgen {
namespace {

TEST(HeightSlab, AFlatSlabIsABox) {
    const HeightField field{{0, 1, 3}, {0, 2}, {4, 4, 4, 4, 4, 4}};
    const Mesh mesh = height_slab(field);
    EXPECT_TRUE(is_closed(mesh));
    EXPECT_DOUBLE_EQ(volume(mesh), 3.0 * 2.0 * 4.0);
    EXPECT_EQ(mesh.triangles.size(), slab_triangles(3, 2));
}

// A point of height 2 in the middle of four unit squares at the height 1. It is a corner of two
// triangles of each square if the diagonal passes it, else of one. The diagonal whose ends differ
// less does not pass it: the four triangles around it with the legs 1 and 1 are a pyramid of the
// base 2 and the height 1.
TEST(HeightSlab, ASquareIsDividedAlongTheDiagonalOfSimilarHeights) {
    HeightField field{{0, 1, 2}, {0, 1, 2}, std::vector<float>(9, 1.0F)};
    field.z[4] = 2.0F;
    const Mesh mesh = height_slab(field);
    EXPECT_TRUE(is_closed(mesh));
    EXPECT_NEAR(volume(mesh), 4.0 + 2.0 / 3.0, 1e-12);
}

// The volume of a slab over one square with the heights 1, 2, 3, 4 (a, b, c, d counter-clockwise):
// |a - c| = |b - d|, so the diagonal is ac, and the volume is (a + b + c) / 6 + (a + c + d) / 6.
TEST(HeightSlab, OneSquareHasAKnownVolume) {
    const Mesh mesh = height_slab({{0, 1}, {0, 1}, {1, 2, 4, 3}});
    EXPECT_TRUE(is_closed(mesh));
    EXPECT_NEAR(volume(mesh), (1.0 + 2.0 + 3.0) / 6.0 + (1.0 + 3.0 + 4.0) / 6.0, 1e-12);
}

}  // namespace
}  // namespace foam::texgen
