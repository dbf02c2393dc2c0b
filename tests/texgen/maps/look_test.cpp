// Colours of bubbles, wet films, shades and light.
#include "core/foam/honeycomb.h"
#include "tests/support/raster_frames.h"
#include "tests/texgen/maps/map_subjects.h"
#include "texgen/maps/cell_color.h"
#include "texgen/maps/film_look.h"
#include "texgen/maps/lit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <vector>

namespace foam::texgen {
namespace {

constexpr int kSize = 96;

Frame hexagons() {
    return snapshot(foam::honeycomb(4, 4), 1);
}

TEST(CellColor, AreasAndSidesOfAHoneycombAreInTheMiddleOfTheScale) {
    for (const ColorBy by : {ColorBy::Area, ColorBy::Sides}) {
        AlbedoOptions options;
        options.color_by = by;
        for (const double tone : tones_of(hexagons(), options)) {
            EXPECT_NEAR(tone, 0.5, 1e-12);
        }
    }
}

TEST(CellColor, ChanceIsOfABubbleAndDoesNotChangeWithTheFoam) {
    AlbedoOptions options;
    options.color_by = ColorBy::Random;
    const PerBubble<double> before = tones_of(test::torus_subject().frame, options);
    const PerBubble<double> after = tones_of(test::torus_subject().next, options);
    EXPECT_EQ(before, after);
    EXPECT_GE(*std::ranges::min_element(before), 0.0);
    EXPECT_LT(*std::ranges::max_element(before), 1.0);
    EXPECT_GT(*std::ranges::max_element(before) - *std::ranges::min_element(before), 0.8);
}

TEST(CellColor, ColorsOfYourOwnAreBlendedInSrgbOrPicked) {
    AlbedoOptions options;
    options.color_by = ColorBy::Area;
    options.colors = {"#000000", "#ff8000", "#ffffff"};
    EXPECT_EQ(to_srgb8(cell_colors(hexagons(), options).front()), (Srgb8{255, 128, 0}));
    options.colors = {"#000000", "#808080"};
    EXPECT_EQ(to_srgb8(cell_colors(hexagons(), options).front()), (Srgb8{64, 64, 64}));
    options.color_mix = ColorMix::Pick;
    EXPECT_EQ(to_srgb8(cell_colors(hexagons(), options).front()), (Srgb8{128, 128, 128}));
}

TEST(CellColor, VariationIsOfLightAndStaysWithinItsPart) {
    AlbedoOptions options;
    options.colors = {"#808080"};
    options.variation = 0.25;
    const double grey = to_linear(parse_color("#808080")).r;
    std::vector<double> light;
    for (const LinearRgb& color : cell_colors(test::torus_subject().frame, options)) {
        EXPECT_EQ(color.r, color.b);
        light.push_back(color.r / grey);
    }
    EXPECT_GE(*std::ranges::min_element(light), 0.75);
    EXPECT_LE(*std::ranges::max_element(light), 1.25);
    EXPECT_GT(*std::ranges::max_element(light) - *std::ranges::min_element(light), 0.3);
}

double sum_of(const Image<float>& image) {
    double sum = 0.0;
    for (const float sample : image.samples()) {
        sum += static_cast<double>(sample);
    }
    return sum;
}

FrameLayers layers_of(const Frame& frame, const FoamRecord& record, const RasterGrid& grid) {
    return {{frame, record, nullptr, {.smooth = true}}, grid, 1};
}

// The smooth distance of a circle of radius R is (R² - r²) / 2R.
TEST(FilmLook, AWetFilmOfACircleEndsWhereItsSmoothDistanceIsHalfTheWidth) {
    constexpr double kRadius = 40.0;
    const Frame frame = snapshot(foam::test::circles({{7, {0.0, 0.0}, std::numbers::pi}}), 1);
    const FoamRecord record;
    FrameLayers layers =
        layers_of(frame, record, {kSize, kSize, 0, 0, View{Vec2::Zero(), kRadius}});
    AlbedoOptions options;
    options.film_width = 8.0;
    options.film_profile = FilmProfile::Wet;
    const double inner = std::sqrt(kRadius * kRadius - 8.0 * kRadius);
    const double outer = kRadius + 4.0;
    const double ring = std::numbers::pi * (outer * outer - inner * inner);
    EXPECT_NEAR(sum_of(film_cover(layers, options)) / ring, 1.0, 2e-3);
    EXPECT_NEAR(
        sum_of(foam_cover(layers, options)) / (std::numbers::pi * outer * outer), 1.0, 2e-3);
}

TEST(FilmLook, WetFilmsCoverWhatEvenOnesDoAndTheCornersBesides) {
    const test::MapSubject& subject = test::torus_subject();
    FrameLayers layers = layers_of(subject.frame, subject.record, test::torus_grid(kSize));
    AlbedoOptions options;
    options.film_width = 4.0;
    const Image<float> even = film_cover(layers, options);
    options.film_profile = FilmProfile::Wet;
    const Image<float> wet = film_cover(layers, options);
    for (std::size_t k = 0; k < even.samples().size(); ++k) {
        if (even.samples()[k] == 1.0F) {
            EXPECT_GT(wet.samples()[k], 0.95F);
        }
    }
    EXPECT_GT(sum_of(wet), 1.05 * sum_of(even));
}

TEST(FilmLook, AShadeIsStrongestAtFilmsAndEndsWithItsWidth) {
    const test::MapSubject& subject = test::torus_subject();
    FrameLayers layers = layers_of(subject.frame, subject.record, test::torus_grid(kSize));
    AlbedoOptions options;
    options.shade = 0.6;
    options.shade_width = 0.2;
    const Image<float> shades = film_shade(layers, options);
    const double reach =
        diameters_in_pixels(options.shade_width, layers.grid(), subject.frame.domain);
    const std::span<const float> smooth = layers.distance().smooth.samples();
    for (std::size_t k = 0; k < smooth.size(); ++k) {
        const float shade = shades.samples()[k];
        if (static_cast<double>(smooth[k]) >= reach) {
            EXPECT_EQ(shade, 0.0F);
        } else {
            EXPECT_GT(shade, 0.0F);
            EXPECT_LE(shade, 0.6F);
        }
    }
    EXPECT_GT(*std::ranges::max_element(shades.samples()), 0.59F);
}

Image<std::uint16_t> lit_pixels(const test::MapSubject& subject, const MapOptions& options) {
    return std::get<ColorPixels>(draw("lit", subject, test::torus_grid(kSize), 1, options)).pixels;
}

TEST(Lit, FlatGroundKeepsItsColors) {
    MapOptions options;
    options.relief.strength = 0.0;
    options.lit.samples = 1;
    options.lit.gloss = 2.0;
    options.lit.rim = 1.0;
    const auto albedo = std::get<ColorPixels>(
        draw("albedo", test::torus_subject(), test::torus_grid(kSize), 1, options));
    EXPECT_EQ(lit_pixels(test::torus_subject(), options), albedo.pixels);
}

TEST(Lit, WhatGlowsKeepsItsColorInTheShadow) {
    MapOptions options;
    options.albedo.film_color = "#ff8000";
    options.albedo.film_width = 6.0;
    options.lit.samples = 1;
    options.lit.glow = 1.0;
    const test::MapSubject& subject = test::torus_subject();
    FrameLayers layers = layers_of(subject.frame, subject.record, test::torus_grid(kSize));
    const Image<float> films = film_cover(layers, options.albedo);
    const Image<std::uint16_t> lit = lit_pixels(subject, options);
    const LinearRgb film = to_linear(parse_color("#ff8000"));
    int glowing = 0;
    for (std::size_t k = 0; k < films.samples().size(); ++k) {
        if (films.samples()[k] == 1.0F) {
            EXPECT_EQ(lit.samples()[3 * k + 1], light_step(film.g));
            ++glowing;
        }
    }
    EXPECT_GT(glowing, 100);
}

// Of a dome, the half that faces the light.
TEST(Lit, LightComesFromItsAzimuth) {
    const Frame frame = snapshot(foam::test::circles({{7, {0.0, 0.0}, std::numbers::pi}}), 1);
    const FoamRecord record;
    const auto right_over_left = [&](double azimuth) {
        FrameLayers layers =
            layers_of(frame, record, {kSize, kSize, 0, 0, View{Vec2::Zero(), 40.0}});
        MapOptions options;
        options.lit.azimuth = azimuth;
        const Image<std::uint16_t> image = draw_lit(layers, options).pixels;
        const auto light = [&](int x) { return static_cast<double>(image.pixel(x, kSize / 2)[1]); };
        return light(kSize / 2 + 20) / light(kSize / 2 - 20);
    };
    EXPECT_GT(right_over_left(0.0), 1.5);
    EXPECT_LT(right_over_left(180.0), 1.0 / 1.5);
    EXPECT_NEAR(right_over_left(90.0), 1.0, 0.05);
}

}  // namespace
}  // namespace foam::texgen
