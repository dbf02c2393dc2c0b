// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/glow.h"

#include "tests/texgen/maps/lone_circle.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace foam::texgen {
namespace {

// A bubble of radius 20 pixels, whose film is 4 pixels wide and glows.
struct Glowing {
    test::LoneCircle circle{20.0};
    AlbedoOptions albedo = test::films_of(4.0);
    ThinFilmOptions thin_film;
    MazeOptions maze;

    Image<float> fractions(double glow) {
        const SurfaceColors surface{LitColors::Albedo, albedo, thin_film, maze};
        return glow_fractions(
            circle.layers, surface, draw_surface_colors(circle.layers, surface), glow);
    }
};

TEST(Glow, IsThatOfFilms) {
    const Image<float> fractions = Glowing().fractions(0.5);
    EXPECT_EQ(fractions.pixel(32, 32)[0], 0.0F);
    EXPECT_NEAR(fractions.pixel(51, 32)[0], 0.5, 1e-4);
    EXPECT_EQ(fractions.pixel(1, 32)[0], 0.0F);
}

// In the middle of the bubble, 20 pixels from the film, the shade has the weight
// 0.8 (1 - smoothstep(20 / width)), where the width is 2 diameters of 40 pixels.
TEST(Glow, IncludesTheShadeBesideFilms) {
    Glowing glowing;
    glowing.albedo.shade = 0.8;
    glowing.albedo.shade_width = 2.0;
    const double passed = 20.0 / 80.0;
    const double weight = 0.8 * (1.0 - passed * passed * (3.0 - 2.0 * passed));
    EXPECT_NEAR(glowing.fractions(1.0).pixel(32, 32)[0], weight, 0.05);
    EXPECT_NEAR(glowing.fractions(1.0).pixel(51, 32)[0], 1.0, 1e-4);
}

// The outer half of the film covers pixels on the rim of the patch partly. The part that it covers
// glows completely.
TEST(Glow, OfARimIsThatOfThePartThatThePatchCovers) {
    const Image<float> fractions = Glowing().fractions(1.0);
    const auto row = [&](int x) { return fractions.pixel(x, 32)[0]; };
    int rims = 0;
    for (int x = 52; x < 64; ++x) {
        EXPECT_TRUE(row(x) == 0.0F || row(x) > 0.99F) << x;
        rims += row(x) > 0.99F ? 1 : 0;
    }
    EXPECT_GE(rims, 1);
}

}  // namespace
}  // namespace foam::texgen
