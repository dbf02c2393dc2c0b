// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/bleed.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace foam::texgen {
namespace {

using Image16 = Image<std::uint16_t>;
using Color = std::array<std::uint16_t, 3>;

void set(Image16& image, int x, int y, const Color& color, std::uint16_t opacity) {
    const auto pixel = image.pixel(x, y);
    std::copy(color.begin(), color.end(), pixel.begin());
    pixel[3] = opacity;
}

Color color_at(const Image16& image, int x, int y) {
    const auto pixel = image.pixel(x, y);
    return {pixel[0], pixel[1], pixel[2]};
}

TEST(Bleed, KeepsPixelsThatAreNotFullyTransparent) {
    Image16 image(2, 1, 4);
    set(image, 0, 0, {10, 20, 30}, 1);
    set(image, 1, 0, {40, 50, 60}, 65535);
    const Image16 before = image;
    bleed_colors(image.view(), {0, 0, 0});
    EXPECT_EQ(image, before);
}

// A pixel beside both colored pixels gets their mean, weighted by their opacities, 2 : 1. A pixel
// far from both gets the same mean.
TEST(Bleed, GivesTheMeanOfTheNearestByOpacity) {
    Image16 image(4, 4, 4);
    set(image, 0, 0, {300, 0, 60000}, 60000);
    set(image, 1, 1, {600, 30000, 0}, 30000);
    bleed_colors(image.view(), {9, 9, 9});
    const Color mean{400, 10000, 40000};
    EXPECT_EQ(color_at(image, 0, 0), (Color{300, 0, 60000}));
    EXPECT_EQ(color_at(image, 1, 0), mean);
    EXPECT_EQ(color_at(image, 0, 1), mean);
    EXPECT_EQ(color_at(image, 2, 2), (Color{600, 30000, 0}));  // beside the second one only
    EXPECT_EQ(color_at(image, 3, 3), mean);
    EXPECT_EQ(image.pixel(3, 3)[3], 0);
}

// A pixel that touches no colored pixel gets the color of the smallest square that contains one.
// The square of the pixel (7, 0) is the whole image.
TEST(Bleed, UsesTheSmallestSquareThatContainsAColor) {
    Image16 image(8, 8, 4);
    set(image, 0, 0, {100, 0, 0}, 65535);
    set(image, 7, 7, {0, 100, 0}, 65535);
    bleed_colors(image.view(), {9, 9, 9});
    EXPECT_EQ(color_at(image, 3, 2), (Color{100, 0, 0}));
    EXPECT_EQ(color_at(image, 4, 6), (Color{0, 100, 0}));
    EXPECT_EQ(color_at(image, 7, 0), (Color{50, 50, 0}));
}

TEST(Bleed, UsesTheFallbackIfAllIsTransparent) {
    for (const int size : {1, 3, 5}) {
        Image16 image(size, 4, 4);
        bleed_colors(image.view(), {1, 2, 3});
        EXPECT_EQ(color_at(image, size - 1, 3), (Color{1, 2, 3}));
    }
}

// The width and the height are not powers of two. Every pixel still gets a color.
TEST(Bleed, ReachesEveryPixelOfAnySize) {
    Image16 image(37, 11, 4);
    set(image, 36, 10, {7, 8, 9}, 3);
    bleed_colors(image.view(), {0, 0, 0});
    for (int y = 0; y < 11; ++y) {
        for (int x = 0; x < 37; ++x) {
            ASSERT_EQ(color_at(image, x, y), (Color{7, 8, 9}));
        }
    }
}

}  // namespace
}  // namespace foam::texgen
