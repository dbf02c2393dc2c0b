// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/dds.h"

#include "tests/support/limited_address_space.h"
#include "tests/support/sanitizers.h"
#include "texgen/image/byte_reader.h"
#include "texgen/image/memory.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace foam::texgen {
namespace {

// An array of two layers of 2 x 1 texels with two mip levels.
GpuTexture small_array() {
    const auto image = [](int first, int count) {
        Bytes bytes;
        for (int k = 0; k < count; ++k) {
            bytes.push_back(static_cast<std::byte>(first + k));
        }
        return bytes;
    };
    return {.format = PixelFormat::R8,
            .width = 2,
            .height = 1,
            .is_array = true,
            .opaque = true,
            .layers = {{image(1, 2), image(3, 1)}, {image(4, 2), image(6, 1)}},
            .text = {}};
}

std::uint32_t number_at(const Bytes& bytes, std::size_t position) {
    return ByteReader(std::span(bytes).subspan(position)).number();
}

// The numbers that the reference of DDS_HEADER and DDS_HEADER_DXT10 gives, at their positions.
TEST(Dds, HasTheHeaderOfDirect3d10) {
    const Bytes bytes = encode_dds(small_array());
    ASSERT_EQ(bytes.size(), 4U + 124U + 20U + 6U);
    EXPECT_EQ(number_at(bytes, 0), 0x20534444U);   // "DDS "
    EXPECT_EQ(number_at(bytes, 4), 124U);          // size of the header
    EXPECT_EQ(number_at(bytes, 8), 0x2100fU);      // caps, height, width, pitch, format, mip levels
    EXPECT_EQ(number_at(bytes, 12), 1U);           // height
    EXPECT_EQ(number_at(bytes, 16), 2U);           // width
    EXPECT_EQ(number_at(bytes, 20), 2U);           // bytes of a row
    EXPECT_EQ(number_at(bytes, 28), 2U);           // mip levels
    EXPECT_EQ(number_at(bytes, 76), 32U);          // size of the pixel format
    EXPECT_EQ(number_at(bytes, 80), 4U);           // it is a four-character code
    EXPECT_EQ(number_at(bytes, 84), 0x30315844U);  // "DX10"
    EXPECT_EQ(number_at(bytes, 108), 0x401008U);   // texture, complex, mip levels
    EXPECT_EQ(number_at(bytes, 128), 61U);         // DXGI_FORMAT_R8_UNORM
    EXPECT_EQ(number_at(bytes, 132), 3U);          // two-dimensional
    EXPECT_EQ(number_at(bytes, 140), 2U);          // layers
    EXPECT_EQ(number_at(bytes, 144), 3U);          // opaque
}

// The levels of the first layer come before those of the second one.
TEST(Dds, StoresLayerAfterLayer) {
    const Bytes bytes = encode_dds(small_array());
    for (std::size_t k = 0; k < 6; ++k) {
        EXPECT_EQ(std::to_integer<std::size_t>(bytes[148 + k]), k + 1);
    }
}

TEST(Dds, IsReadAsItWasWritten) {
    const GpuTexture texture = small_array();
    const GpuTexture back = decode_dds(encode_dds(texture));
    EXPECT_EQ(back.format, texture.format);
    EXPECT_EQ(back.width, 2);
    EXPECT_EQ(back.height, 1);
    EXPECT_TRUE(back.is_array);
    EXPECT_TRUE(back.opaque);
    EXPECT_EQ(back.layers, texture.layers);
}

TEST(Dds, EveryTruncationIsAnInputError) {
    const Bytes bytes = encode_dds(small_array());
    for (std::size_t size = 0; size < bytes.size(); ++size) {
        EXPECT_THROW(decode_dds(std::span(bytes).first(size)), InputError) << size;
    }
    Bytes longer = bytes;
    longer.push_back(std::byte{0});
    EXPECT_THROW(decode_dds(longer), InputError);
}

// Each of these numbers makes the header malformed, or gives the file a property that foamtex does
// not support. The position is that of the lowest byte of the number.
TEST(Dds, RejectsInvalidHeaders) {
    struct Change {
        std::size_t position;
        std::uint32_t number;
        const char* reason;
    };
    const std::vector<Change> changes = {{0, 0, "does not begin with"},
                                         {4, 100, "124 bytes"},
                                         {12, 0, "no pixels"},
                                         {16, 0, "no pixels"},
                                         {16, 2'000'000, "more than foamtex reads"},
                                         {28, 3, "mip levels"},
                                         {84, 0x31545844, "no header of Direct3D 10"},
                                         {128, 2, "pixel format 2"},
                                         {132, 4, "not two-dimensional"},
                                         {136, 4, "a cube"},
                                         {140, 0, "0 layers"},
                                         {140, 5000, "5000 layers"},
                                         {144, 2, "premultiplied alpha"}};
    for (const Change& change : changes) {
        Bytes bytes = encode_dds(small_array());
        const auto number = little_endian(change.number);
        std::copy(number.begin(),
                  number.end(),
                  bytes.begin() + static_cast<std::ptrdiff_t>(change.position));
        try {
            decode_dds(bytes);
            ADD_FAILURE() << change.position;
        } catch (const InputError& error) {
            EXPECT_NE(std::string(error.what()).find(change.reason), std::string::npos)
                << error.what();
        }
    }
}

// The images of 32 MiB are not copied if only 16 MiB of memory are left.
TEST(Dds, ImagesBeyondTheMemoryAreRejected) {
    if (foam::test::kMayHaveSanitizers) {
        GTEST_SKIP() << "sanitizers need a large address space";
    }
    const std::size_t size = std::size_t{8192} * 4096;
    const Bytes bytes = encode_dds({.format = PixelFormat::R8,
                                    .width = 8192,
                                    .height = 4096,
                                    .layers = {{Bytes(size)}},
                                    .text = {}});
    const foam::test::LimitedAddressSpace limited(size / 2);
    EXPECT_THROW(decode_dds(bytes), OutOfMemory);
}

}  // namespace
}  // namespace foam::texgen
