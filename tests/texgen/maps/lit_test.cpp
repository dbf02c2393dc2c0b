// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/lit.h"

#include "tests/support/sample_foams.h"
#include "tests/texgen/keys/limits.h"
#include "tests/texgen/maps/map_subjects.h"
#include "texgen/maps/all_maps.h"
#include "texgen/maps/film_coverage.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <numbers>
#include <variant>

namespace foam::texgen {
namespace {

constexpr int kSize = 96;

FrameLayers layers_of(const Frame& frame, const FoamRecord& record, const RasterGrid& grid) {
    return {{frame, record, nullptr, {.smooth = true}}, grid, 1};
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

TEST(Lit, GlowKeepsItsColorInTheShadow) {
    MapOptions options;
    options.albedo.film_color = "#ff8000";
    options.albedo.film_width = 6.0;
    options.lit.samples = 1;
    options.lit.glow = 1.0;
    const test::MapSubject& subject = test::torus_subject();
    FrameLayers layers = layers_of(subject.frame, subject.record, test::torus_grid(kSize));
    const Image<float> films = film_coverage(layers, options.albedo);
    const Image<std::uint16_t> lit = lit_pixels(subject, options);
    const LinearRgb film = to_linear(parse_color("#ff8000"));
    int glowing = 0;
    for (std::size_t k = 0; k < films.samples().size(); ++k) {
        if (films.samples()[k] == 1.0F) {
            EXPECT_EQ(lit.samples()[3 * k + 1], to_sample(film.g));
            ++glowing;
        }
    }
    EXPECT_GT(glowing, 100);
}

// The half of a dome that faces the light is brighter than the other half.
TEST(Lit, LightComesFromItsAzimuth) {
    const Frame frame = snapshot(foam::test::circles({{7, {0.0, 0.0}, std::numbers::pi}}), 1);
    const FoamRecord record;
    const auto right_over_left = [&](double azimuth) {
        FrameLayers layers =
            layers_of(frame, record, {kSize, kSize, 0, 0, View{Vec2::Zero(), 40.0}});
        MapOptions options;
        options.lit.azimuth = azimuth;
        const Image<std::uint16_t> image = draw_lit(layers,
                                                    options.lit,
                                                    {options.albedo,
                                                     options.thin_film,
                                                     {options.relief, options.maze},
                                                     options.occlusion})
                                               .pixels;
        const auto light = [&](int x) { return static_cast<double>(image.pixel(x, kSize / 2)[1]); };
        return light(kSize / 2 + 20) / light(kSize / 2 - 20);
    };
    EXPECT_GT(right_over_left(0.0), 1.5);
    EXPECT_LT(right_over_left(180.0), 1.0 / 1.5);
    EXPECT_NEAR(right_over_left(90.0), 1.0, 0.05);
}

TEST(Lit, LimitsHoldOnBothSides) {
    test::expect_limits(lit_keys(),
                        {{"azimuth", "-361", "-360", "360", "361"},
                         {"elevation", "0.9", "1", "90", "91"},
                         {"ambient", "-0.1", "0", "1", "1.1"},
                         {"gloss", "-0.1", "0", "1000", "1001"},
                         {"shininess", "0.9", "1", "10000", "10001"},
                         {"rim", "-0.1", "0", "1000", "1001"},
                         {"glow", "-0.1", "0", "1", "1.1"},
                         {"samples", "0", "1", "8", "9"}});
}

TEST(Lit, ChoicesHaveTheirWords) {
    test::expect_words(lit_keys(), "colors", {"albedo", "thin_film", "maze"});
}

}  // namespace
}  // namespace foam::texgen
