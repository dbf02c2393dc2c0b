// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/film_coverage.h"

#include "tests/support/sample_foams.h"
#include "tests/texgen/maps/lone_circle.h"
#include "tests/texgen/maps/map_subjects.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>

namespace foam::texgen {
namespace {

constexpr int kSize = 96;

FrameLayers layers_of(const Frame& frame, const FoamRecord& record, const RasterGrid& grid) {
    return {{frame, record, nullptr, {.smooth = SmoothImages::DistanceAndGradient}}, grid, 1};
}

// The smooth distance of a circle of radius R is (R² - r²) / 2R.
TEST(FilmCoverage, AWetFilmOfACircleEndsWhereItsSmoothDistanceIsHalfTheWidth) {
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
    EXPECT_NEAR(test::sum_of(film_coverage(layers, options)) / ring, 1.0, 2e-3);
    EXPECT_NEAR(test::sum_of(foam_coverage(layers, options)) / (std::numbers::pi * outer * outer),
                1.0,
                2e-3);
}

TEST(FilmCoverage, WetFilmsOfNoWidthCoverNothing) {
    const test::MapSubject& subject = test::torus_subject();
    FrameLayers layers = layers_of(subject.frame, subject.record, test::torus_grid(kSize));
    AlbedoOptions options;
    options.film_width = 0.0;
    options.film_profile = FilmProfile::Wet;
    EXPECT_EQ(test::sum_of(film_coverage(layers, options)), 0.0);
}

TEST(FilmCoverage, WetFilmsCoverEvenFilmsAndCorners) {
    const test::MapSubject& subject = test::torus_subject();
    FrameLayers layers = layers_of(subject.frame, subject.record, test::torus_grid(kSize));
    AlbedoOptions options;
    options.film_width = 4.0;
    const Image<float> even = film_coverage(layers, options);
    options.film_profile = FilmProfile::Wet;
    const Image<float> wet = film_coverage(layers, options);
    for (std::size_t k = 0; k < even.samples().size(); ++k) {
        if (even.samples()[k] == 1.0F) {
            EXPECT_GT(wet.samples()[k], 0.95F);
        }
    }
    EXPECT_GT(test::sum_of(wet), 1.05 * test::sum_of(even));
}

TEST(FilmCoverage, AShadeIsStrongestAtFilmsAndEndsWithItsWidth) {
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

}  // namespace
}  // namespace foam::texgen
