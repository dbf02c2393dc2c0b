// SPDX-License-Identifier: Apache-2.0

#include "texgen/pictures/silhouette.h"

#include <gtest/gtest.h>

#include <cstdint>

namespace foam::texgen {
namespace {

constexpr std::uint16_t kFull = 65535;

// Returns a picture of one color.
SourcePicture flat(int width, int height, std::uint16_t light, std::uint16_t opacity) {
    SourcePicture picture{{width, height, 4}};
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const auto pixel = picture.pixels.pixel(x, y);
            pixel[0] = pixel[1] = pixel[2] = light;
            pixel[3] = opacity;
        }
    }
    return picture;
}

// Sets the light and the opacity of a square of 10 x 10 pixels.
void paint_square(SourcePicture& picture, int left, std::uint16_t light, std::uint16_t opacity) {
    for (int y = 5; y < 15; ++y) {
        for (int x = left; x < left + 10; ++x) {
            const auto pixel = picture.pixels.pixel(x, y);
            pixel[0] = pixel[1] = pixel[2] = light;
            pixel[3] = opacity;
        }
    }
}

TEST(Silhouette, IsTheDarkPartOfAnOpaquePicture) {
    SourcePicture picture = flat(40, 20, kFull, kFull);
    paint_square(picture, 5, 0, kFull);
    const auto parts = silhouette(picture);
    ASSERT_EQ(parts.size(), 1U);
    EXPECT_NEAR(outline_area(parts[0]), 100.0, 1.0);
}

// The lightness 1/2 is the light 0.2140 of sRGB.
TEST(Silhouette, IsDarkUpToHalfLightness) {
    SourcePicture picture = flat(40, 20, kFull, kFull);
    paint_square(picture, 5, static_cast<std::uint16_t>(0.20 * kFull), kFull);
    EXPECT_EQ(silhouette(picture).size(), 1U);
    paint_square(picture, 5, static_cast<std::uint16_t>(0.23 * kFull), kFull);
    EXPECT_TRUE(silhouette(picture).empty());
}

// A dark square and a white one, both opaque, on transparent ground.
TEST(Silhouette, IsTheOpaquePartIfThereIsATransparentOne) {
    SourcePicture picture = flat(40, 20, 0, 0);
    paint_square(picture, 5, 0, kFull);
    paint_square(picture, 25, kFull, kFull);
    EXPECT_EQ(silhouette(picture).size(), 2U);
}

TEST(Silhouette, HasHoles) {
    SourcePicture picture = flat(40, 20, 0, kFull);
    paint_square(picture, 5, kFull, kFull);
    const auto parts = silhouette(picture);
    ASSERT_EQ(parts.size(), 1U);
    EXPECT_EQ(parts[0].holes.size(), 1U);
    EXPECT_NEAR(outline_area(parts[0]), 700.0, 2.0);
}

// A picture of 3000 x 1000 pixels is above two million pixels: squares of 2 x 2 pixels are
// averaged.
TEST(Silhouette, AveragesLargePictures) {
    SourcePicture picture = flat(3000, 1000, kFull, kFull);
    for (int y = 0; y < 1000; ++y) {
        for (int x = 500; x < 1500; ++x) {
            const auto pixel = picture.pixels.pixel(x, y);
            pixel[0] = pixel[1] = pixel[2] = 0;
        }
    }
    const auto parts = silhouette(picture);
    ASSERT_EQ(parts.size(), 1U);
    EXPECT_NEAR(outline_area(parts[0]), 250'000.0, 100.0);
}

}  // namespace
}  // namespace foam::texgen
