// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/thin_film.h"

#include "tests/support/sample_foams.h"
#include "tests/texgen/keys/limits.h"
#include "texgen/maps/film_reflectance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace foam::texgen {
namespace {

// Without variation and drainage, the film of a lone bubble is as thick in the middle as the option
// says. Gravity of 0.5 removes half of the thickness at the top and adds half at the bottom, in
// proportion to the height.
TEST(ThinFilm, GravityMakesTheTopThinAndTheBottomThick) {
    constexpr int kSize = 101;
    constexpr double kRadius = 40.0;
    const Frame frame = snapshot(foam::test::circles({{7, {0.0, 0.0}, std::numbers::pi}}), 1);
    const FoamRecord record;
    FrameLayers layers({frame, record, nullptr, {.smooth = SmoothImages::DistanceAndGradient}},
                       {kSize, kSize, 0, 0, View{Vec2::Zero(), kRadius}},
                       1);
    const ThinFilmOptions options{
        .thickness = 200.0, .variation = 0.0, .drainage = 0.0, .gravity = 0.5, .exposure = 8.0};
    AlbedoOptions albedo;
    albedo.film_width = 1.0;
    const Image<std::uint16_t> image = draw_thin_film(layers, options, albedo).pixels;
    for (const int y : {-30, -10, 0, 10, 30}) {
        const double thickness = 200.0 * (1.0 - 0.5 * y / kRadius);
        const LinearRgb light = film_reflectance(thickness);
        const auto pixel = image.pixel(kSize / 2, kSize / 2 + y);
        EXPECT_NEAR(pixel[1] / kWhite, 8.0 * light.g, 0.02) << y;
    }
}

// Two bubbles of one size have different swirls.
TEST(ThinFilm, SwirlsBelongToTheirBubble) {
    const auto pixels_of = [](BubbleIdentity identity, double swirl) {
        const Frame frame =
            snapshot(foam::test::circles({{identity, {0.0, 0.0}, std::numbers::pi}}), 1);
        const FoamRecord record;
        FrameLayers layers({frame, record, nullptr, {.smooth = SmoothImages::DistanceAndGradient}},
                           {64, 64, 0, 0, View{Vec2::Zero(), 28.0}},
                           1);
        const ThinFilmOptions options{.variation = 0.0, .swirl = swirl};
        return draw_thin_film(layers, options, {}).pixels;
    };
    EXPECT_EQ(pixels_of(3, 0.0), pixels_of(4, 0.0));
    EXPECT_NE(pixels_of(3, 0.3), pixels_of(3, 0.0));
    EXPECT_NE(pixels_of(3, 0.3), pixels_of(4, 0.3));
}

TEST(ThinFilm, LimitsHoldOnBothSides) {
    test::expect_limits(thin_film_keys(),
                        {{"thickness", "-1", "0", "3000", "3001"},
                         {"variation", "-1", "0", "2", "2.1"},
                         {"drainage", "-1", "0", "10", "11"},
                         {"gravity", "-1", "0", "10", "11"},
                         {"swirl", "-1", "0", "10", "11"},
                         {"exposure", "-1", "0", "100", "101"}});
}

}  // namespace
}  // namespace foam::texgen
