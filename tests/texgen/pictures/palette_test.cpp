// SPDX-License-Identifier: Apache-2.0

#include "texgen/pictures/palette.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace foam::texgen {
namespace {

constexpr std::uint16_t kFull = 65535;

// Returns a picture of one row with the given colors, which are all opaque.
SourcePicture picture_of(const std::vector<Srgb8>& colors) {
    SourcePicture picture{{static_cast<int>(colors.size()), 1, 4}};
    for (std::size_t k = 0; k < colors.size(); ++k) {
        const LinearRgb light = to_linear(colors[k]);
        const auto pixel = picture.pixels.pixel(static_cast<int>(k), 0);
        pixel[0] = static_cast<std::uint16_t>(light.r * kFull + 0.5);
        pixel[1] = static_cast<std::uint16_t>(light.g * kFull + 0.5);
        pixel[2] = static_cast<std::uint16_t>(light.b * kFull + 0.5);
        pixel[3] = kFull;
    }
    return picture;
}

constexpr Srgb8 kRed{200, 20, 20};
constexpr Srgb8 kBlue{20, 20, 120};
constexpr Srgb8 kSand{240, 220, 180};

TEST(Palette, FindsTheColorsOfFlatPicturesByLightness) {
    const SourcePicture picture = picture_of({kSand, kRed, kBlue, kRed, kSand, kSand});
    EXPECT_EQ(palette_of(picture, 3), (std::vector<Srgb8>{kBlue, kRed, kSand}));
    EXPECT_EQ(palette_of(picture, 10), (std::vector<Srgb8>{kBlue, kRed, kSand}));
}

// Two colors remain: the most different pair stays apart, and the others join the nearest one.
TEST(Palette, GroupsSimilarColors) {
    const Srgb8 other_red{206, 22, 18};
    const std::vector<Srgb8> found = palette_of(picture_of({kRed, other_red, kBlue}), 2);
    ASSERT_EQ(found.size(), 2U);
    EXPECT_EQ(found[0], kBlue);
    EXPECT_GE(found[1].r, kRed.r);
    EXPECT_LE(found[1].r, other_red.r);
}

TEST(Palette, DoesNotCountTransparentPixels) {
    SourcePicture picture = picture_of({kRed, kBlue, kSand});
    picture.pixels.pixel(1, 0)[3] = 0;
    EXPECT_EQ(palette_of(picture, 3), (std::vector<Srgb8>{kRed, kSand}));
    picture.pixels.pixel(0, 0)[3] = 0;
    picture.pixels.pixel(2, 0)[3] = 0;
    EXPECT_TRUE(palette_of(picture, 3).empty());
}

// The centers are at the means of their clusters: k-means has converged. One cluster is the mean of
// all pixels; in Oklab, the mean of black and white has the lightness 0.5, which is the sRGB
// code 99.
TEST(Palette, TakesMeansInOklab) {
    EXPECT_EQ(palette_of(picture_of({{0, 0, 0}, {255, 255, 255}}), 1),
              (std::vector<Srgb8>{{99, 99, 99}}));
}

// One pixel of a thousand is no color of its own if two other colors are frequent.
TEST(Palette, IgnoresOutliers) {
    std::vector<Srgb8> colors(1000, kBlue);
    std::fill(colors.begin(), colors.begin() + 500, kSand);
    colors[999] = {0, 255, 0};
    const std::vector<Srgb8> found = palette_of(picture_of(colors), 2);
    EXPECT_NEAR(found[0].b, kBlue.b, 3);
    EXPECT_NEAR(found[1].b, kSand.b, 3);
}

}  // namespace
}  // namespace foam::texgen
