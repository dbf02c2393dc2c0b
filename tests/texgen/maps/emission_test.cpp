// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/emission.h"

#include "tests/texgen/maps/lone_circle.h"
#include "tests/texgen/maps/map_subjects.h"
#include "texgen/maps/all_maps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <variant>

namespace foam::texgen {
namespace {

constexpr int kSize = 96;

Image<std::uint16_t> drawn(const char* map, const MapOptions& options) {
    const MapImage image = draw(map, test::torus_subject(), test::torus_grid(kSize), 1, options);
    return std::get<ColorPixels>(image).pixels;
}

MapOptions glowing(double glow) {
    MapOptions options;
    options.albedo.film_color = "#ff8000";
    options.albedo.film_width = 5.0;
    options.albedo.shade = 0.6;
    options.albedo.shade_color = "#0040ff";
    options.lit.glow = glow;
    return options;
}

TEST(Emission, IsBlackWithoutGlow) {
    const Image<std::uint16_t> emission = drawn("emission", glowing(0.0));
    EXPECT_TRUE(std::ranges::all_of(emission.samples(), [](int sample) { return sample == 0; }));
}

TEST(Emission, IsProportionalToTheGlow) {
    const Image<std::uint16_t> full = drawn("emission", glowing(1.0));
    const Image<std::uint16_t> half = drawn("emission", glowing(0.5));
    for (std::size_t k = 0; k < full.samples().size(); ++k) {
        EXPECT_NEAR(half.samples()[k], full.samples()[k] / 2.0, 1.0);
    }
}

// A pixel of the map lit is its emitted light plus its reflected light. The reflected light is the
// light of a surface that does not glow, times the fraction of the color that is not emitted. Light
// above white is cut off, so white pixels are left out.
TEST(Emission, IsTheEmittedPartOfTheMapLit) {
    MapOptions options = glowing(0.8);
    options.lit.samples = 1;
    options.lit.light.gloss = 0.0;
    const Image<std::uint16_t> lit = drawn("lit", options);
    const Image<std::uint16_t> emission = drawn("emission", options);
    const Image<std::uint16_t> albedo = drawn("albedo", options);
    options.lit.glow = 0.0;
    const Image<std::uint16_t> reflected = drawn("lit", options);
    int compared = 0;
    for (std::size_t k = 0; k < lit.samples().size(); ++k) {
        if (reflected.samples()[k] == kWhite) {
            continue;
        }
        ++compared;
        const double color = albedo.samples()[k];
        const double emitted = emission.samples()[k];
        const double fraction = color > 0.0 ? emitted / color : 0.0;
        EXPECT_NEAR(lit.samples()[k], emitted + (1.0 - fraction) * reflected.samples()[k], 3.0);
    }
    EXPECT_GT(compared, kSize * kSize);
}

TEST(Emission, IsTransparentAroundAPatch) {
    test::LoneCircle circle(20.0);
    const AlbedoOptions albedo = test::films_of(4.0);
    const ThinFilmOptions thin_film;
    const MazeOptions maze;
    const ColorPixels emission =
        draw_emission(circle.layers, {LitColors::Albedo, albedo, thin_film, maze}, 1.0);
    EXPECT_EQ(emission.pixels.pixel(1, 32)[3], 0);
    EXPECT_EQ(emission.pixels.pixel(51, 32)[3], kWhite);
    EXPECT_EQ(emission.pixels.pixel(51, 32)[0], kWhite);  // films are white by default
    EXPECT_EQ(emission.pixels.pixel(32, 32)[0], 0);
}

}  // namespace
}  // namespace foam::texgen
