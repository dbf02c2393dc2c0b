// SPDX-License-Identifier: Apache-2.0

#include "texgen/sheet/display_frame.h"

#include "tests/texgen/sheet/shown_pictures.h"
#include "texgen/image/color.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace foam::texgen {
namespace {

// Half of black and half of white is half the light, which sRGB codes as 188, not 128.
TEST(DisplayFrame, AveragesLightOfColors) {
    const auto image = picture(2, 1, 3, {0, 0, 0, 255, 255, 255});
    EXPECT_EQ(codes(reduced(shown(image, "sRGB"), 1, 1)),
              (std::vector<std::uint8_t>{188, 188, 188}));
}

TEST(DisplayFrame, AveragesDataAsItIs) {
    const auto image = picture(2, 1, 3, {0, 10, 20, 100, 110, 120});
    EXPECT_EQ(codes(reduced(shown(image, "data"), 1, 1)), (std::vector<std::uint8_t>{50, 60, 70}));
}

// 3 pixels become 2: each of these covers one and a half. Light of 0.3 and 0.9 in steps of 15 of
// 255.
TEST(DisplayFrame, WeighsByArea) {
    const auto image = picture(3, 1, 1, {30, 60, 90});
    const DisplayFrame smaller = reduced(shown(image, "data"), 2, 1);
    EXPECT_EQ(codes(smaller), (std::vector<std::uint8_t>{40, 40, 40, 80, 80, 80}));
}

TEST(DisplayFrame, KeepsEveryCodeAtItsOwnSize) {
    Image<std::uint8_t> image(16, 16, 3);
    for (std::size_t k = 0; k < image.samples().size(); ++k) {
        image.samples()[k] = static_cast<std::uint8_t>(k);
    }
    for (const char* color_space : {"sRGB", "data"}) {
        EXPECT_EQ(codes_of(reduced(shown(image, color_space), 16, 16)), image);
    }
}

// Shifting the image by whole pixels of the smaller image shifts the smaller image, because no
// pixel is computed across the border.
TEST(DisplayFrame, StaysATile) {
    Image<std::uint8_t> image(12, 8, 1);
    Image<std::uint8_t> moved(12, 8, 1);
    for (int y = 0; y < 8; ++y) {
        for (int x = 0; x < 12; ++x) {
            image.pixel(x, y)[0] = static_cast<std::uint8_t>(x * x * 7 + 31 * y);
            moved.pixel((x + 3) % 12, (y + 2) % 8)[0] = image.pixel(x, y)[0];
        }
    }
    const Image<std::uint8_t> small = codes_of(reduced(shown(image, "data"), 4, 4));
    const Image<std::uint8_t> small_moved = codes_of(reduced(shown(moved, "data"), 4, 4));
    for (int y = 0; y < 4; ++y) {
        for (int x = 0; x < 4; ++x) {
            EXPECT_TRUE(
                std::ranges::equal(small.pixel(x, y), small_moved.pixel((x + 1) % 4, (y + 1) % 4)));
        }
    }
}

}  // namespace
}  // namespace foam::texgen
