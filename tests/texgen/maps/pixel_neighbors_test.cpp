// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/pixel_neighbors.h"

#include <gtest/gtest.h>

namespace foam::texgen {
namespace {

// The pixels of a row have consecutive indices: row 0 has 0 to 3, row 1 has 4 to 7, row 2 has 8
// to 11.
const RasterGrid kGrid{4, 3};

TEST(PixelNeighbors, AreBesideAPixelInTheImage) {
    const PixelNeighbors neighbors(kGrid, Domain{4.0, 3.0});
    EXPECT_EQ(neighbors.left(5), 4U);
    EXPECT_EQ(neighbors.right(5), 6U);
    EXPECT_EQ(neighbors.below(5), 1U);
    EXPECT_EQ(neighbors.above(5), 9U);
}

TEST(PixelNeighbors, WrapAroundATorus) {
    const PixelNeighbors neighbors(kGrid, Domain{4.0, 3.0});
    EXPECT_EQ(neighbors.left(4), 7U);
    EXPECT_EQ(neighbors.right(7), 4U);
    EXPECT_EQ(neighbors.below(1), 9U);
    EXPECT_EQ(neighbors.above(9), 1U);
}

// The row above the last one is displaced by the shear, which need not be whole pixels.
TEST(PixelNeighbors, EndAtTheTopOfAShearedTorus) {
    const PixelNeighbors neighbors(kGrid, Domain{4.0, 3.0, 0.3});
    EXPECT_EQ(neighbors.left(4), 7U);
    EXPECT_EQ(neighbors.below(1), 1U);
    EXPECT_EQ(neighbors.above(9), 9U);
}

TEST(PixelNeighbors, EndAtTheBorderOfThePlane) {
    const PixelNeighbors neighbors(kGrid, Domain{0.0, 0.0});
    EXPECT_EQ(neighbors.left(4), 4U);
    EXPECT_EQ(neighbors.right(7), 7U);
    EXPECT_EQ(neighbors.below(1), 1U);
    EXPECT_EQ(neighbors.above(9), 9U);
}

}  // namespace
}  // namespace foam::texgen
