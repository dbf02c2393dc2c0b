// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/pixel_hash.h"

#include "texgen/image/exr.h"
#include "texgen/image/png.h"

#include <gtest/gtest.h>
#include <xxhash.h>

#include <array>
#include <cstdio>
#include <string>
#include <vector>

namespace foam::texgen {
namespace {

/// Returns 2 x 2 pixels with the samples 1, 11, 21, ...; row 0 is the bottom row.
template <class Sample>
Image<Sample> small_image(int channels) {
    Image<Sample> image(2, 2, channels);
    for (std::size_t k = 0; k < image.samples().size(); ++k) {
        image.samples()[k] = static_cast<Sample>(10 * k + 1);
    }
    return image;
}

std::string hash_of(const std::string& bytes) {
    const XXH128_hash_t hash = XXH3_128bits(bytes.data(), bytes.size());
    std::array<char, 33> digits{};
    std::snprintf(digits.data(),
                  digits.size(),
                  "%016llx%016llx",
                  static_cast<unsigned long long>(hash.high64),
                  static_cast<unsigned long long>(hash.low64));
    return digits.data();
}

std::string hash_of(const Image<std::uint8_t>& codes) {
    return pixel_hash({{code_channels(codes)}});
}

// The hash is computed from a line of text and the samples, the top row first (pixel_hash.h).
TEST(PixelHash, IsOfALineAndTheSamplesFromTheTop) {
    const Image<std::uint8_t> gray = small_image<std::uint8_t>(1);  // 1 11 below, 21 31 above
    EXPECT_EQ(pixel_hash({{code_channels(gray)}}), hash_of("Y u8 2x2\n\x15\x1f\x01\x0b"));
    Image<std::uint16_t> deep(1, 2, 1);
    deep.row(0)[0] = 0x0102;
    deep.row(1)[0] = 0x0304;
    EXPECT_EQ(pixel_hash({{code_channels(deep)}}), hash_of("Y u16 1x2\n\x04\x03\x02\x01"));
}

TEST(PixelHash, CoversABlockPerChannelInTheOrderOfNames) {
    Image<float> numbers(1, 1, 1);
    numbers.samples()[0] = 1.0F;  // 0x3f800000
    Image<float> halves(1, 1, 1);
    halves.samples()[0] = 0.5F;  // 0x3800 as a half
    Image<std::uint32_t> ids(1, 1, 1);
    ids.samples()[0] = 0x01020304U;
    const Picture picture{{{{"id.Y"}, SampleType::Uint32, ids},
                           {{"b"}, SampleType::Half, halves},
                           {{"a"}, SampleType::Float, numbers}}};
    std::string expected = "a f32 1x1\n";
    expected += std::string("\x00\x00\x80\x3f", 4);
    expected += "b f16 1x1\n";
    expected += std::string("\x00\x38", 2);
    expected += "id.Y u32 1x1\n\x04\x03\x02\x01";
    EXPECT_EQ(pixel_hash(picture), hash_of(expected));
}

// Channels that are interleaved in one group have the same hash as channels in separate groups.
TEST(PixelHash, OfNumbersDoesNotDependOnTheirGroups) {
    Image<float> both(1, 1, 2);
    both.samples()[0] = 1.0F;
    both.samples()[1] = 2.0F;
    Image<float> first(1, 1, 1);
    first.samples()[0] = 1.0F;
    Image<float> second(1, 1, 1);
    second.samples()[0] = 2.0F;
    EXPECT_EQ(
        pixel_hash({{{{"X", "Y"}, SampleType::Float, both}}}),
        pixel_hash({{{{"Y"}, SampleType::Float, second}, {{"X"}, SampleType::Float, first}}}));
}

// The hash depends on the pixels, but not on their compression or on the metadata.
TEST(PixelHash, OfAPngIsThatOfTheEncodedPicture) {
    for (int channels = 1; channels <= 4; ++channels) {
        const Picture deep{{code_channels(small_image<std::uint16_t>(channels))},
                           {.color = true, .text = {{"Seed", "3"}}}};
        EXPECT_EQ(pixel_hash(decode_png(encode_png(deep))), pixel_hash(deep));
        const Picture small{{code_channels(small_image<std::uint8_t>(channels))}};
        EXPECT_EQ(pixel_hash(decode_png(encode_png(small, {.filter = PngFilter::Up}))),
                  pixel_hash(small));
    }
}

// A third is not a half float. The hash is that of the rounded number, before encoding and after
// decoding.
TEST(PixelHash, OfAnExrIsThatOfTheEncodedPicture) {
    Image<float> numbers(3, 2, 1);
    for (std::size_t k = 0; k < numbers.samples().size(); ++k) {
        numbers.samples()[k] = static_cast<float>(k) / 3.0F;
    }
    for (const SampleType type : {SampleType::Half, SampleType::Float}) {
        const Picture picture{{{{"z.Y"}, type, numbers},
                               {{"id.Y"}, SampleType::Uint32, Image<std::uint32_t>(3, 2, 1)}}};
        for (const bool mip_levels : {false, true}) {
            const Picture read = decode_exr(encode_exr(picture, {.mip_levels = mip_levels}));
            EXPECT_EQ(pixel_hash(read), pixel_hash(picture));
        }
    }
}

TEST(PixelHash, DependsOnEverySampleExtentAndType) {
    const Image<std::uint8_t> image = small_image<std::uint8_t>(1);
    Image<std::uint8_t> other = image;
    other.samples()[3] ^= 1U;
    Image<std::uint8_t> wide(4, 1, 1);
    Image<std::uint8_t> turned(2, 2, 1);
    for (std::size_t k = 0; k < 4; ++k) {
        wide.samples()[k] = image.samples()[k];
        turned.samples()[k] = image.samples()[(k + 2) % 4];
    }
    EXPECT_NE(hash_of(other), hash_of(image));
    EXPECT_NE(hash_of(wide), hash_of(image));
    EXPECT_NE(hash_of(turned), hash_of(image));
    EXPECT_EQ(hash_of(image).size(), 32U);
}

}  // namespace
}  // namespace foam::texgen
