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

// Where both apply, points are rounded as to_subpixel rounds them.
TEST(FixedPoint, RoundsFarPoints) {
    for (int k = -5000; k < 5000; ++k) {
        const Vec2 point(k / 3072.0, k / 7168.0);
        const SubpixelPoint near = to_subpixel(point);
        EXPECT_EQ(rounded_to_subpixels(point), Vec2(near.x, near.y));
    }
    EXPECT_EQ(rounded_to_subpixels({-1e8, 3e6 + 0.6 / 1024}), Vec2(-1024e8, 3072e6 + 1.0));
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
