// SPDX-License-Identifier: Apache-2.0

#include "texgen/raster/coords/fixed_point.h"

#include <gtest/gtest.h>

namespace foam::texgen {
namespace {

TEST(FixedPoint, RoundsToTheNearestSubpixelOnBothSidesOfZero) {
    EXPECT_EQ(to_subpixel(1.0), 1024);
    EXPECT_EQ(to_subpixel(-1.0), -1024);
    EXPECT_EQ(to_subpixel(0.49 / 1024), 0);
    EXPECT_EQ(to_subpixel(0.51 / 1024), 1);
    EXPECT_EQ(to_subpixel(-0.49 / 1024), 0);
    EXPECT_EQ(to_subpixel(-0.51 / 1024), -1);
}

TEST(FixedPoint, RoundingCommutesWithWholePixels) {
    for (int k = -5000; k < 5000; ++k) {
        const double x = k / 3072.0;
        EXPECT_EQ(to_subpixel(x + 1234.0), to_subpixel(x) + 1234 * kSubpixel) << x;
    }
}

TEST(FixedPoint, DividesDownwards) {
    EXPECT_EQ(floor_div(7, 4), 1);
    EXPECT_EQ(floor_div(-1, 4), -1);
    EXPECT_EQ(floor_div(-4, 4), -1);
    EXPECT_EQ(wrap(-1, 4), 3);
    EXPECT_EQ(wrap(8, 4), 0);
    EXPECT_EQ(pixel_of(-1), -1);
}

}  // namespace
}  // namespace foam::texgen
