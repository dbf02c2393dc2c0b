// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/lit.h"

#include "tests/support/sample_foams.h"
#include "tests/texgen/keys/limits.h"
#include "tests/texgen/maps/map_subjects.h"
#include "texgen/maps/all_maps.h"
#include "texgen/maps/film_coverage.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <variant>
#include <vector>

namespace foam::texgen {
namespace {

constexpr int kSize = 96;

FrameLayers layers_of(const Frame& frame, const FoamRecord& record, const RasterGrid& grid) {
    return {{frame, record, nullptr, {.smooth = SmoothImages::DistanceAndGradient}}, grid, 1};
}

Image<std::uint16_t> lit_pixels(const test::MapSubject& subject, const MapOptions& options) {
    return std::get<ColorPixels>(draw("lit", subject, test::torus_grid(kSize), 1, options)).pixels;
}

TEST(Lit, FlatGroundKeepsItsColors) {
    MapOptions options;
    options.relief.strength = 0.0;
    options.lit.samples = 1;
    options.lit.light.gloss = 2.0;
    options.lit.light.rim = 1.0;
    options.lit.light.reflections.windows = 2;
    options.lit.light.reflections.horizon = 1.0;
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
        options.lit.light.azimuth = azimuth;
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

// Returns the mean of each square of kFiner² pixels of an image.
constexpr int kFiner = 4;

std::vector<double> means_of_squares(const Image<std::uint16_t>& fine) {
    std::vector<double> means;
    for (int y = 0; y < fine.height() / kFiner; ++y) {
        for (int x = 0; x < fine.width() / kFiner; ++x) {
            double sum = 0.0;
            for (int k = 0; k < kFiner * kFiner; ++k) {
                sum += fine.pixel(kFiner * x + k % kFiner, kFiner * y + k / kFiner)[1];
            }
            means.push_back(sum / (kFiner * kFiner));
        }
    }
    return means;
}

// A pixel shows the mean light over its area: an image differs little from the means of an image
// with four times as many pixels in each direction, also at creases and at highlights.
TEST(Lit, AgreesWithTheMeansOfAFinerImage) {
    MapOptions options;
    options.albedo.colors = {"#808080"};
    options.albedo.film_width = 0.0;
    options.lit.light.reflections.windows = 2;
    for (const auto profile : {ReliefProfile::Dome, ReliefProfile::Ridge, ReliefProfile::Wet}) {
        options.relief.profile = profile;
        const auto drawn = [&](int size) {
            return std::get<ColorPixels>(
                       draw("lit", test::torus_subject(), test::torus_grid(size), 1, options))
                .pixels;
        };
        const Image<std::uint16_t> image = drawn(kSize);
        const std::vector<double> means = means_of_squares(drawn(kFiner * kSize));
        double errors = 0.0;
        for (std::size_t k = 0; k < means.size(); ++k) {
            errors += std::abs(image.samples()[3 * k + 1] - means[k]) / kWhite;
        }
        EXPECT_LT(errors / static_cast<double>(means.size()), 0.006);
    }
}

constexpr double kDomeRadius = 40.0;  // pixels

// Returns the picture of a lone black bubble in the middle of the image, without highlights.
Image<std::uint16_t> lit_dome(MapOptions options) {
    const Frame frame = snapshot(foam::test::circles({{7, {0.0, 0.0}, std::numbers::pi}}), 1);
    const FoamRecord record;
    FrameLayers layers =
        layers_of(frame, record, {kSize, kSize, 0, 0, View{Vec2::Zero(), kDomeRadius}});
    options.albedo.colors = {"#000000"};
    options.albedo.film_width = 0.0;
    options.lit.light.gloss = 0.0;
    return draw_lit(layers,
                    options.lit,
                    {options.albedo,
                     options.thin_film,
                     {options.relief, options.maze},
                     options.occlusion})
        .pixels;
}

// A spherical dome of 60 degrees reflects the window where its normal points halfway between the
// viewer and the window. On a sphere of radius r, whose section is R = r sin 60°, a slope of the
// angle a is at the distance r sin a from the middle.
TEST(Lit, ReflectsAWindowHalfwayToTheLight) {
    MapOptions options;
    options.relief.angle = 60.0;
    options.lit.light.azimuth = 0.0;
    options.lit.light.elevation = 50.0;
    options.lit.light.reflections.windows = 2;
    options.lit.light.reflections.window_size = 20.0;
    const Image<std::uint16_t> image = lit_dome(options);
    const double sphere = kDomeRadius / std::sin(std::numbers::pi / 3.0);
    const int at = static_cast<int>(sphere * std::sin(20.0 * std::numbers::pi / 180.0));
    const auto light = [&](int x) { return image.pixel(kSize / 2 + x, kSize / 2)[1] / kWhite; };
    EXPECT_GT(light(at), 0.95);
    EXPECT_NEAR(light(-at), 0.4, 0.05);
    EXPECT_LT(light(0), 0.01);
    EXPECT_LT(light(2 * at), 0.01);
}

// The horizon is reflected where the slope is 45 degrees: light above, none below.
TEST(Lit, ReflectsTheHorizonAsARing) {
    MapOptions options;
    options.relief.angle = 75.0;
    options.lit.light.reflections.horizon = 1.0;
    const Image<std::uint16_t> image = lit_dome(options);
    const double sphere = kDomeRadius / std::sin(75.0 * std::numbers::pi / 180.0);
    const auto light = [&](double degrees, double x, double y) {
        const double r = sphere * std::sin(degrees * std::numbers::pi / 180.0);
        return image.pixel(kSize / 2 + static_cast<int>(r * x),
                           kSize / 2 + static_cast<int>(r * y))[1] /
               kWhite;
    };
    for (const auto& [x, y] : {std::pair(1.0, 0.0), std::pair(0.0, 1.0), std::pair(-1.0, 0.0)}) {
        EXPECT_GT(light(41.0, x, y), 0.4);
        EXPECT_LT(light(57.0, x, y), 0.05);
        EXPECT_LT(light(10.0, x, y), 0.05);
    }
}

TEST(Lit, LimitsHoldOnBothSides) {
    test::expect_limits(lit_keys(),
                        {{"azimuth", "-361", "-360", "360", "361"},
                         {"elevation", "0.9", "1", "90", "91"},
                         {"ambient", "-0.1", "0", "1", "1.1"},
                         {"gloss", "-0.1", "0", "1000", "1001"},
                         {"shininess", "0.9", "1", "10000", "10001"},
                         {"rim", "-0.1", "0", "1000", "1001"},
                         {"windows", "-1", "0", "2", "3"},
                         {"window_size", "0.9", "1", "120", "121"},
                         {"window_softness", "-0.1", "0", "1", "1.1"},
                         {"window_brightness", "-0.1", "0", "1000", "1001"},
                         {"horizon", "-0.1", "0", "1000", "1001"},
                         {"glow", "-0.1", "0", "1", "1.1"},
                         {"samples", "0", "1", "8", "9"}});
}

TEST(Lit, ChoicesHaveTheirWords) {
    test::expect_words(lit_keys(), "colors", {"albedo", "thin_film", "maze"});
}

}  // namespace
}  // namespace foam::texgen
