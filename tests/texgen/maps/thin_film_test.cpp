// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/thin_film.h"

#include "tests/support/sample_foams.h"
#include "tests/texgen/keys/limits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace foam::texgen {
namespace {

double luminance(const LinearRgb& color) {
    return 0.2126 * color.r + 0.7152 * color.g + 0.0722 * color.b;
}

TEST(ThinFilm, OfNoThicknessIsBlack) {
    const LinearRgb color = film_reflectance(0.0);
    EXPECT_EQ(luminance(color), 0.0);
}

// Each of the two surfaces reflects R = (0.33 / 2.33)² of the light. At a thickness of a quarter of
// the wavelength in the liquid, the reflections are in phase and give 4 R / (1 + R)² = 0.0771. At
// 555 nm, where the eye is most sensitive, a quarter of the wavelength is 104 nm. Other wavelengths
// reflect a little less.
TEST(ThinFilm, OfAQuarterWaveIsBrightest) {
    const double single = std::pow(0.33 / 2.33, 2);
    const double maximum = 4.0 * single / std::pow(1.0 + single, 2);
    EXPECT_NEAR(luminance(film_reflectance(104.0)), maximum, 0.04 * maximum);
    EXPECT_GT(luminance(film_reflectance(104.0)), luminance(film_reflectance(80.0)));
    EXPECT_GT(luminance(film_reflectance(104.0)), luminance(film_reflectance(130.0)));
}

// At half the wavelength of green light in the liquid, 207 nm, green is missing. This is the first
// purple of Newton's series. It is followed by blue, green and yellow.
TEST(ThinFilm, HasNewtonsColors) {
    const LinearRgb purple = film_reflectance(207.0);
    EXPECT_GT(purple.r, 2.0 * purple.g);
    EXPECT_GT(purple.b, 2.0 * purple.g);
    const LinearRgb blue = film_reflectance(245.0);
    EXPECT_GT(blue.b, blue.r);
    EXPECT_GT(blue.b, blue.g);
    const LinearRgb green = film_reflectance(285.0);
    EXPECT_GT(green.g, green.r);
    EXPECT_GT(green.g, green.b);
    const LinearRgb yellow = film_reflectance(330.0);
    EXPECT_GT(yellow.r, yellow.b);
    EXPECT_GT(yellow.g, yellow.b);
}

// Without variation and drainage, the film of a lone bubble is as thick in the middle as the option
// says. Gravity of 0.5 removes half of the thickness at the top and adds half at the bottom, in
// proportion to the height.
TEST(ThinFilm, GravityMakesTheTopThinAndTheBottomThick) {
    constexpr int kSize = 101;
    constexpr double kRadius = 40.0;
    const Frame frame = snapshot(foam::test::circles({{7, {0.0, 0.0}, std::numbers::pi}}), 1);
    const FoamRecord record;
    FrameLayers layers({frame, record, nullptr, {.smooth = true}},
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
        FrameLayers layers({frame, record, nullptr, {.smooth = true}},
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
