// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/film_reflectance.h"

#include <gtest/gtest.h>

#include <cmath>

namespace foam::texgen {
namespace {

double luminance(const LinearRgb& color) {
    return 0.2126 * color.r + 0.7152 * color.g + 0.0722 * color.b;
}

TEST(FilmReflectance, OfNoThicknessIsBlack) {
    const LinearRgb color = film_reflectance(0.0);
    EXPECT_EQ(luminance(color), 0.0);
}

// Each of the two surfaces reflects R = (0.33 / 2.33)² of the light. At a thickness of a quarter of
// the wavelength in the liquid, the reflections are in phase and give 4 R / (1 + R)² = 0.0771. At
// 555 nm, where the eye is most sensitive, a quarter of the wavelength is 104 nm. Other wavelengths
// reflect a little less.
TEST(FilmReflectance, OfAQuarterWaveIsBrightest) {
    const double single = std::pow(0.33 / 2.33, 2);
    const double maximum = 4.0 * single / std::pow(1.0 + single, 2);
    EXPECT_NEAR(luminance(film_reflectance(104.0)), maximum, 0.04 * maximum);
    EXPECT_GT(luminance(film_reflectance(104.0)), luminance(film_reflectance(80.0)));
    EXPECT_GT(luminance(film_reflectance(104.0)), luminance(film_reflectance(130.0)));
}

// At half the wavelength of green light in the liquid, 207 nm, green is missing. This is the first
// purple of Newton's series. It is followed by blue, green and yellow.
TEST(FilmReflectance, HasNewtonsColors) {
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

}  // namespace
}  // namespace foam::texgen
