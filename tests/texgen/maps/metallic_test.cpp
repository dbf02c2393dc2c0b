// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/metallic.h"

#include "tests/texgen/keys/limits.h"
#include "tests/texgen/maps/lone_circle.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace foam::texgen {
namespace {

using test::LoneCircle;

// The circle has a radius of 20 pixels around the middle of an image of 64 x 64 pixels, and films
// are 4 pixels wide. The pixel (51, 32) is within the film, the pixel (1, 32) outside of the patch.
TEST(Metallic, IsThatOfCellsAndFilms) {
    LoneCircle circle(20.0);
    const Image<float> metallic =
        draw_metallic(circle.layers, {.cell = 0.25, .film = 1.0}, test::films_of(4.0)).pixels;
    EXPECT_NEAR(metallic.pixel(32, 32)[0], 0.25, 1e-5);
    EXPECT_NEAR(metallic.pixel(51, 32)[0], 1.0, 1e-5);
    EXPECT_EQ(metallic.pixel(1, 32)[0], 0.0F);
}

TEST(Metallic, IsZeroByDefault) {
    LoneCircle circle(20.0);
    const Image<float> metallic = draw_metallic(circle.layers, {}, test::films_of(4.0)).pixels;
    EXPECT_TRUE(std::ranges::all_of(metallic.samples(), [](float value) { return value == 0.0F; }));
}

TEST(Metallic, LimitsHoldOnBothSides) {
    test::expect_limits(metallic_keys(),
                        {{"cell", "-0.1", "0", "1", "1.1"}, {"film", "-0.1", "0", "1", "1.1"}});
}

}  // namespace
}  // namespace foam::texgen
