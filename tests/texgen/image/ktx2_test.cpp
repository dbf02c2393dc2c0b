// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/ktx2.h"

#include "tests/support/limited_address_space.h"
#include "tests/support/sanitizers.h"
#include "texgen/image/byte_reader.h"
#include "texgen/image/memory.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace foam::texgen {
namespace {

// An array of two layers of 8 x 4 texels with four mip levels, without alpha.
GpuTexture small_array() {
    GpuTexture texture{.format = PixelFormat::Bc7Srgb,
                       .width = 8,
                       .height = 4,
                       .is_array = true,
                       .opaque = true,
                       .layers = {{}, {}},
                       .text = {{"Preset", "a\n\"b\""}, {"Map", "albedo"}}};
    int first = 0;
    for (std::vector<Bytes>& layer : texture.layers) {
        for (const std::size_t blocks : {2U, 1U, 1U, 1U}) {
            Bytes bytes(16 * blocks);
            std::ranges::generate(bytes, [&] { return static_cast<std::byte>(first++); });
            layer.push_back(bytes);
        }
    }
    return texture;
}

template <class Number = std::uint32_t>
Number number_at(const Bytes& bytes, std::size_t position) {
    return ByteReader(std::span(bytes).subspan(position)).number<Number>();
}

// The numbers that the KTX File Format Specification 2.0 gives, at their positions.
TEST(Ktx2, HasTheHeaderOfTheSpecification) {
    const Bytes bytes = encode_ktx2(small_array());
    EXPECT_EQ(number_at(bytes, 0), 0x58544babU);  // 0xab "KTX"
    EXPECT_EQ(number_at(bytes, 12), 146U);        // VK_FORMAT_BC7_SRGB_BLOCK
    EXPECT_EQ(number_at(bytes, 16), 1U);          // size of the data type
    EXPECT_EQ(number_at(bytes, 20), 8U);          // width
    EXPECT_EQ(number_at(bytes, 24), 4U);          // height
    EXPECT_EQ(number_at(bytes, 28), 0U);          // depth
    EXPECT_EQ(number_at(bytes, 32), 2U);          // layers
    EXPECT_EQ(number_at(bytes, 36), 1U);          // faces
    EXPECT_EQ(number_at(bytes, 40), 4U);          // mip levels
    EXPECT_EQ(number_at(bytes, 44), 2U);          // Zstandard
    const std::size_t descriptor = 80 + 4 * 24;
    EXPECT_EQ(number_at(bytes, 48), descriptor);
    EXPECT_EQ(number_at(bytes, descriptor), 44U);  // size of the descriptor
    EXPECT_EQ(number_at(bytes, descriptor + 8), 2U | 40U << 16U);
    EXPECT_EQ(number_at(bytes, descriptor + 12), 134U | 1U << 8U | 2U << 16U);  // BC7, BT.709, sRGB
    EXPECT_EQ(number_at(bytes, descriptor + 16), 0x303U);       // blocks of 4 x 4 texels
    EXPECT_EQ(number_at(bytes, descriptor + 20), 16U);          // bytes per block
    EXPECT_EQ(number_at(bytes, descriptor + 28), 127U << 16U);  // one sample of 128 bits
}

// The full size is the last part of the file, and level 0 of the index names it.
TEST(Ktx2, LevelsAreStoredFromTheSmallest) {
    const Bytes bytes = encode_ktx2(small_array());
    std::uint64_t end = bytes.size();
    for (std::size_t level = 0; level < 4; ++level) {
        const std::size_t entry = 80 + 24 * level;
        const auto offset = number_at<std::uint64_t>(bytes, entry);
        const auto size = number_at<std::uint64_t>(bytes, entry + 8);
        EXPECT_EQ(offset + size, end);
        EXPECT_EQ(number_at<std::uint64_t>(bytes, entry + 16), level == 0 ? 64U : 32U);
        end = offset;
    }
}

TEST(Ktx2, IsReadAsItWasWritten) {
    const GpuTexture texture = small_array();
    const GpuTexture back = decode_ktx2(encode_ktx2(texture));
    EXPECT_EQ(back.format, texture.format);
    EXPECT_EQ(back.width, 8);
    EXPECT_EQ(back.height, 4);
    EXPECT_TRUE(back.is_array);
    EXPECT_TRUE(back.opaque);
    EXPECT_EQ(back.layers, texture.layers);
    const std::vector<std::pair<std::string, std::string>> sorted = {{"Map", "albedo"},
                                                                     {"Preset", "a\n\"b\""}};
    EXPECT_EQ(back.text, sorted);
}

// KTXanimData has three numbers: the duration of a frame in time units, the time units per second,
// and the number of loops, which is 0 for an animation without an end. 24000 frames in 1001 seconds
// are frames of 1001 units, of which a second has 24000.
TEST(Ktx2, AnArrayStoresItsAnimation) {
    GpuTexture texture = small_array();
    for (const bool repeats : {true, false}) {
        texture.animation = {.rate = {24000, 1001}, .repeats = repeats};
        const Bytes bytes = encode_ktx2(texture);
        const std::string key("KTXanimData\0", 12);
        const auto searched = std::as_bytes(std::span(key));
        const auto found =
            std::search(bytes.begin(), bytes.end(), searched.begin(), searched.end());
        ASSERT_NE(found, bytes.end());
        const auto position = static_cast<std::size_t>(found - bytes.begin());
        EXPECT_EQ(number_at(bytes, position - 4), 24U);  // bytes of the key and the value
        EXPECT_EQ(number_at(bytes, position + 12), 1001U);
        EXPECT_EQ(number_at(bytes, position + 16), 24000U);
        EXPECT_EQ(number_at(bytes, position + 20), repeats ? 0U : 1U);
        EXPECT_EQ(decode_ktx2(bytes).animation, texture.animation);
    }
}

// The specification allows an animation for arrays alone.
TEST(Ktx2, ASingleTextureStoresNoAnimation) {
    GpuTexture texture = small_array();
    texture.is_array = false;
    texture.layers.pop_back();
    texture.animation = {.rate = {24, 1}, .repeats = true};
    EXPECT_FALSE(decode_ktx2(encode_ktx2(texture)).animation);
}

TEST(Ktx2, RejectsAnAnimationWithoutFrameRate) {
    GpuTexture texture = small_array();
    texture.animation = {.rate = {24, 0}, .repeats = true};
    EXPECT_THROW(decode_ktx2(encode_ktx2(texture)), InputError);
    texture.animation = {.rate = {0, 1}, .repeats = true};
    EXPECT_THROW(decode_ktx2(encode_ktx2(texture)), InputError);
}

TEST(Ktx2, ATextureWithAlphaIsNotOpaque) {
    GpuTexture texture = small_array();
    texture.opaque = false;
    EXPECT_FALSE(decode_ktx2(encode_ktx2(texture)).opaque);
}

TEST(Ktx2, EveryTruncationIsAnInputError) {
    const Bytes bytes = encode_ktx2(small_array());
    for (std::size_t size = 0; size < bytes.size(); ++size) {
        EXPECT_THROW(decode_ktx2(std::span(bytes).first(size)), InputError) << size;
    }
}

// Each of these numbers makes the file malformed, or gives it a property that foamtex does not
// support. The position is that of the lowest byte of the number.
TEST(Ktx2, RejectsInvalidHeaders) {
    struct Change {
        std::size_t position;
        std::uint32_t number;
        const char* reason;
    };
    const std::vector<Change> changes = {
        {0, 0, "identifier"},
        {12, 1, "pixel format 1"},
        {20, 0, "no pixels"},
        {24, 5'000'000, "more than foamtex reads"},
        {28, 2, "a volume"},
        {32, 9999, "9999 layers"},
        {36, 6, "a cube"},
        {40, 0, "mip levels"},
        {40, 9, "mip levels"},
        {44, 1, "Zstandard"},
        {56, 100'000, "outside of the file"},
        {80, 100'000, "outside of the file"},
        {96, 63, "the wrong size"},
        {188, 1U << 24U | 2U << 16U | 1U << 8U | 134U, "premultiplied alpha"}};
    for (const Change& change : changes) {
        Bytes bytes = encode_ktx2(small_array());
        const auto number = little_endian(change.number);
        std::copy(number.begin(),
                  number.end(),
                  bytes.begin() + static_cast<std::ptrdiff_t>(change.position));
        try {
            decode_ktx2(bytes);
            ADD_FAILURE() << change.position;
        } catch (const InputError& error) {
            EXPECT_NE(std::string(error.what()).find(change.reason), std::string::npos)
                << error.what();
        }
    }
}

// A level of equal bytes is the best case of Zstandard.
TEST(Ktx2, ALevelOfEqualBytesIsRead) {
    GpuTexture texture{.format = PixelFormat::R8,
                       .width = 8192,
                       .height = 4096,
                       .opaque = true,
                       .layers = {{Bytes(std::size_t{8192} * 4096)}},
                       .text = {}};
    const Bytes bytes = encode_ktx2(texture);
    EXPECT_LT(bytes.size(), 8000U);
    EXPECT_EQ(decode_ktx2(bytes).layers, texture.layers);
}

// A level of 32 MiB is not decompressed if only 16 MiB of memory are left.
TEST(Ktx2, ALevelBeyondTheMemoryIsRejected) {
    if (foam::test::kMayHaveSanitizers) {
        GTEST_SKIP() << "sanitizers need a large address space";
    }
    const std::size_t size = std::size_t{8192} * 4096;
    const Bytes bytes = encode_ktx2({.format = PixelFormat::R8,
                                     .width = 8192,
                                     .height = 4096,
                                     .layers = {{Bytes(size)}},
                                     .text = {}});
    const foam::test::LimitedAddressSpace limited(size / 2);
    EXPECT_THROW(decode_ktx2(bytes), OutOfMemory);
}

}  // namespace
}  // namespace foam::texgen
