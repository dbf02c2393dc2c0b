// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/mip_chain.h"

#include "tests/texgen/pictures.h"
#include "texgen/image/color.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace foam::texgen {
namespace {

constexpr int kSize = 16;

// Returns a picture of unrelated codes.
Picture noise(int channels, bool color) {
    Image<std::uint8_t> codes(kSize, kSize, channels);
    std::uint32_t state = 1;
    for (std::uint8_t& code : codes.samples()) {
        state = state * 1664525U + 1013904223U;
        code = static_cast<std::uint8_t>(state >> 24U);
    }
    Picture picture{{code_channels(std::move(codes))}, {}};
    picture.metadata.color = color;
    return picture;
}

Picture picture_of(int width, const std::vector<std::uint8_t>& samples, bool color = false) {
    const auto channels = static_cast<int>(samples.size()) / width;  // the picture has a single row
    Image<std::uint8_t> codes(width, 1, channels);
    std::ranges::copy(samples, codes.samples().begin());
    Picture picture{{code_channels(std::move(codes))}, {}};
    picture.metadata.color = color;
    return picture;
}

Image<std::uint8_t> shifted(const Image<std::uint8_t>& image, int shift) {
    Image<std::uint8_t> result(image.width(), image.height(), image.channels());
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            std::ranges::copy(
                image.pixel((x + shift) % image.width(), (y + shift) % image.height()),
                result.pixel(x, y).begin());
        }
    }
    return result;
}

// A picture that is shifted by 2^k pixels has a level k that is shifted by one pixel, bit for bit.
TEST(MipChain, AShiftOfTheTileIsAShiftOfEveryLevel) {
    for (const TexelMeaning meaning :
         {TexelMeaning::Numbers, TexelMeaning::Normals, TexelMeaning::Ids}) {
        for (const bool color : {false, true}) {
            const Picture picture = noise(color ? 4 : 3, color);
            const std::vector<Picture> levels = mip_chain(picture, meaning);
            ASSERT_EQ(levels.size(), 5U);
            for (int level = 1; level < 5; ++level) {
                Picture moved = picture;
                moved.groups.front().samples = shifted(codes8(picture), 1 << level);
                const Picture expected = levels[static_cast<std::size_t>(level)];
                EXPECT_EQ(codes8(mip_chain(moved, meaning)[static_cast<std::size_t>(level)]),
                          shifted(codes8(expected), 1));
            }
        }
    }
}

TEST(MipChain, NormalsHaveUnitLengthInEveryLevel) {
    Picture picture = noise(3, false);
    for (const Picture& level : mip_chain(picture, TexelMeaning::Normals)) {
        if (level.width() == kSize) {
            continue;  // the picture itself
        }
        const Image<std::uint8_t> codes = codes8(level);
        for (std::size_t k = 0; k < codes.samples().size(); k += 3) {
            double square = 0.0;
            for (std::size_t c = 0; c < 3; ++c) {
                const double component = codes.samples()[k + c] / 127.5 - 1.0;
                square += component * component;
            }
            EXPECT_NEAR(std::sqrt(square), 1.0, 0.01);
        }
    }
}

// The mean light of black and white is 1/2, which is the sRGB code 188. The mean of data is 128.
TEST(MipChain, ColorsAreAveragedAsLight) {
    const Picture colors = picture_of(2, {0, 0, 0, 255, 255, 255}, true);
    EXPECT_EQ(codes8(mip_chain(colors, TexelMeaning::Numbers).back()).samples()[0], 188);
    const Picture data = picture_of(2, {0, 0, 0, 255, 255, 255});
    EXPECT_EQ(codes8(mip_chain(data, TexelMeaning::Numbers).back()).samples()[0], 128);
}

// An opaque red pixel and a transparent green pixel are red of half the opacity. Transparent pixels
// keep their mean color.
TEST(MipChain, ColorsAreWeightedByTheirOpacity) {
    const Picture half = picture_of(2, {255, 0, 0, 255, 0, 255, 0, 0}, true);
    const Image<std::uint8_t> mean = codes8(mip_chain(half, TexelMeaning::Numbers).back());
    EXPECT_EQ(mean.samples()[0], 255);
    EXPECT_EQ(mean.samples()[1], 0);
    EXPECT_EQ(mean.samples()[3], 128);
    const Picture clear = picture_of(2, {255, 0, 0, 0, 255, 0, 0, 0}, true);
    EXPECT_EQ(codes8(mip_chain(clear, TexelMeaning::Numbers).back()).samples()[0], 255);
}

// Every id of a level is an id of the picture.
TEST(MipChain, IdsAreNotMixed) {
    const Picture ids = picture_of(4, {9, 9, 200, 3});
    for (const Picture& level : mip_chain(ids, TexelMeaning::Ids)) {
        const Image<std::uint8_t> codes = codes8(level);
        for (const std::uint8_t code : codes.samples()) {
            EXPECT_TRUE(code == 9 || code == 200 || code == 3) << int{code};
        }
    }
}

}  // namespace
}  // namespace foam::texgen
