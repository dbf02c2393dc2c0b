// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/id_color.h"

#include "tests/texgen/maps/lone_circle.h"

#include <gtest/gtest.h>

#include <cmath>

namespace foam::texgen {
namespace {

using test::LoneCircle;

TEST(IdColor, ColorsOfIdentitiesAreWithinSrgbAndFarApart) {
    for (BubbleIdentity identity = 0; identity < 10000; ++identity) {
        const LinearRgb color = identity_color(identity);
        for (const double channel : {color.r, color.g, color.b}) {
            ASSERT_GE(channel, 0.0) << identity;
            ASSERT_LE(channel, 1.0) << identity;
        }
        const LinearRgb next = identity_color(identity + 1);
        const double apart =
            std::abs(color.r - next.r) + std::abs(color.g - next.g) + std::abs(color.b - next.b);
        ASSERT_GT(apart, 0.15) << identity;
    }
}

TEST(IdColor, ABubbleKeepsItsColor) {
    LoneCircle circle(20.0);
    const ColorPixels image = draw_id_color(circle.layers);
    const LinearRgb color = identity_color(7);
    EXPECT_NEAR(image.pixels.pixel(32, 32)[0] / 65535.0, color.r, 1e-5);
    EXPECT_NEAR(image.pixels.pixel(32, 32)[1] / 65535.0, color.g, 1e-5);
    EXPECT_NEAR(image.pixels.pixel(32, 32)[2] / 65535.0, color.b, 1e-5);
    EXPECT_EQ(image.pixels.pixel(32, 32)[3], 65535);
}

}  // namespace
}  // namespace foam::texgen
