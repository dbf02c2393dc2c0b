// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/gpu_texture.h"

#include "tests/support/limited_address_space.h"
#include "tests/support/sanitizers.h"
#include "tests/texgen/pictures.h"
#include "texgen/image/memory.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <stdexcept>

namespace foam::texgen {
namespace {

// Returns a picture whose codes rise slowly.
template <class Code>
Picture ramp(int width, int height, int channels, bool color = false) {
    Image<Code> codes(width, height, channels);
    int code = 0;
    for (Code& sample : codes.samples()) {
        sample = static_cast<Code>(code++ % 200);
    }
    Picture picture{{code_channels(std::move(codes))}, {}};
    picture.metadata.color = color;
    return picture;
}

TEST(GpuTexture, TheFormatFollowsFromThePicture) {
    const GpuEncoding none{.blocks = BlockCompression::None};
    const GpuEncoding normals{.meaning = TexelMeaning::Normals};
    const GpuEncoding ids{.meaning = TexelMeaning::Ids};
    const Picture color = ramp<std::uint8_t>(4, 4, 3, true);
    const Picture data = ramp<std::uint8_t>(4, 4, 3);
    const Picture gray = ramp<std::uint8_t>(4, 4, 1);
    EXPECT_EQ(pixel_format_of(color, {}), PixelFormat::Bc7Srgb);
    EXPECT_EQ(pixel_format_of(color, none), PixelFormat::Rgba8Srgb);
    EXPECT_EQ(pixel_format_of(data, {}), PixelFormat::Bc7);
    EXPECT_EQ(pixel_format_of(data, normals), PixelFormat::Bc5);
    EXPECT_EQ(pixel_format_of(data, none), PixelFormat::Rgba8);
    EXPECT_EQ(pixel_format_of(gray, {}), PixelFormat::Bc4);
    EXPECT_EQ(pixel_format_of(gray, ids), PixelFormat::R8);
    EXPECT_EQ(pixel_format_of(ramp<std::uint8_t>(6, 4, 3, true), {}), PixelFormat::Rgba8Srgb);
    EXPECT_EQ(pixel_format_of(ramp<std::uint8_t>(4, 5, 1), {}), PixelFormat::R8);
    EXPECT_EQ(pixel_format_of(ramp<std::uint16_t>(4, 4, 1), {}), PixelFormat::R16);
    EXPECT_EQ(pixel_format_of(ramp<std::uint16_t>(4, 4, 3), {}), PixelFormat::Rgba16);
    EXPECT_EQ(pixel_format_of(ramp<std::uint16_t>(4, 4, 3), {.used_channels = 2}),
              PixelFormat::Rg16);
    EXPECT_EQ(pixel_format_of(ramp<std::uint16_t>(4, 4, 4), {.used_channels = 2}),
              PixelFormat::Rgba16);
}

TEST(GpuTexture, HasAllLevels) {
    const GpuTexture texture = texture_of(ramp<std::uint8_t>(20, 6, 3, true), {});
    ASSERT_EQ(texture.levels(), 5);
    for (int level = 0; level < 5; ++level) {
        EXPECT_EQ(texture.layers[0][static_cast<std::size_t>(level)].size(),
                  image_bytes(texture.format, level_extent(20, level), level_extent(6, level)));
    }
    EXPECT_EQ(texture_of(ramp<std::uint8_t>(20, 6, 3), {.mip_levels = false}).levels(), 1);
}

TEST(GpuTexture, WithoutCompressionEverySampleIsKept) {
    const GpuEncoding exact{.blocks = BlockCompression::None};
    for (const int channels : {1, 3, 4}) {
        const Picture coarse = ramp<std::uint8_t>(5, 7, channels, channels > 1);
        EXPECT_EQ(codes8(picture_of(texture_of(coarse, exact))), codes8(coarse));
        const Picture fine = ramp<std::uint16_t>(5, 7, channels);
        EXPECT_EQ(codes16(picture_of(texture_of(fine, exact))), codes16(fine));
    }
}

// The bottom row of a picture is the last row of a texture.
TEST(GpuTexture, RowsRunFromTheTop) {
    Image<std::uint8_t> codes(1, 2, 1);
    codes.pixel(0, 0)[0] = 10;
    codes.pixel(0, 1)[0] = 20;
    const Picture picture{{code_channels(codes)}, {}};
    const Bytes bytes =
        texture_of(picture, {.blocks = BlockCompression::None}).layers.front().front();
    EXPECT_EQ(bytes, (Bytes{std::byte{20}, std::byte{10}}));
}

TEST(GpuTexture, TwoUsedChannelsAreReadWithAThirdOfZeros) {
    Picture picture = ramp<std::uint16_t>(5, 7, 3);
    auto& codes = std::get<Image<std::uint16_t>>(picture.groups.front().samples);
    for (std::size_t k = 2; k < codes.samples().size(); k += 3) {
        codes.samples()[k] = 0;
    }
    EXPECT_EQ(codes16(picture_of(texture_of(picture, {.used_channels = 2}))), codes);
}

// The texture stores x and y of a normal. z follows from them.
TEST(GpuTexture, ZOfANormalIsRebuilt) {
    Image<std::uint8_t> codes(4, 4, 3);
    for (std::size_t k = 0; k < 16; ++k) {
        const double angle = 0.05 * static_cast<double>(k);
        codes.samples()[3 * k] = static_cast<std::uint8_t>(127.5 * std::sin(angle) + 128.0);
        codes.samples()[3 * k + 1] = 128;
        codes.samples()[3 * k + 2] = static_cast<std::uint8_t>(127.5 * std::cos(angle) + 128.0);
    }
    const Picture picture{{code_channels(codes)}, {}};
    const GpuEncoding normals{.meaning = TexelMeaning::Normals};
    const Image<std::uint8_t> decoded = codes8(picture_of(texture_of(picture, normals)));
    for (std::size_t k = 0; k < codes.samples().size(); ++k) {
        EXPECT_NEAR(decoded.samples()[k], codes.samples()[k], 7) << k;
    }
}

TEST(GpuTexture, DoesNotDependOnThreads) {
    const Picture picture = ramp<std::uint8_t>(64, 64, 3, true);
    EXPECT_EQ(texture_of(picture, {.threads = 1}).layers,
              texture_of(picture, {.threads = 3}).layers);
}

// The blocks of 8192 x 4096 texels in BC4 have 16 MiB, and the picture has twice as many bytes.
TEST(GpuTexture, APictureBeyondTheMemoryIsRejected) {
    if (foam::test::kMayHaveSanitizers) {
        GTEST_SKIP() << "sanitizers need a large address space";
    }
    const std::size_t size = image_bytes(PixelFormat::Bc4, 8192, 4096);
    const GpuTexture texture{.format = PixelFormat::Bc4,
                             .width = 8192,
                             .height = 4096,
                             .layers = {{Bytes(size)}},
                             .text = {}};
    const foam::test::LimitedAddressSpace limited(size);
    EXPECT_THROW(picture_of(texture), OutOfMemory);
}

TEST(GpuTexture, RejectsOtherPictures) {
    EXPECT_THROW(texture_of(ramp<std::uint8_t>(4, 4, 2), {}), std::invalid_argument);
    const Picture numbers{{{{"Y"}, SampleType::Float, Image<float>(4, 4, 1)}}};
    EXPECT_THROW(texture_of(numbers, {}), std::invalid_argument);
}

}  // namespace
}  // namespace foam::texgen
