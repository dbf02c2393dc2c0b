// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/data_format.h"

#include "texgen/image/byte_reader.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace foam::texgen {
namespace {

std::vector<std::uint32_t> numbers_of(PixelFormat format) {
    const Bytes bytes = data_format_descriptor(format);
    ByteReader reader(bytes);
    std::vector<std::uint32_t> numbers;
    while (reader.remaining() > 0) {
        numbers.push_back(reader.number());
    }
    return numbers;
}

// A texel of 8 bytes has four samples of 16 bits, of red, green, blue and alpha (channel 15).
TEST(DataFormat, DescribesSamplesOfATexel) {
    const std::vector<std::uint32_t> expected = {92,
                                                 0,
                                                 2U | 88U << 16U,
                                                 1U | 1U << 8U | 1U << 16U,
                                                 0,
                                                 8,
                                                 0,
                                                 0U | 15U << 16U,
                                                 0,
                                                 0,
                                                 0xffff,
                                                 16U | 15U << 16U | 1U << 24U,
                                                 0,
                                                 0,
                                                 0xffff,
                                                 32U | 15U << 16U | 2U << 24U,
                                                 0,
                                                 0,
                                                 0xffff,
                                                 48U | 15U << 16U | 15U << 24U,
                                                 0,
                                                 0,
                                                 0xffff};
    EXPECT_EQ(numbers_of(PixelFormat::Rgba16), expected);
}

// Alpha of an sRGB format is linear: the qualifier is 0x10.
TEST(DataFormat, AlphaIsLinear) {
    const std::vector<std::uint32_t> numbers = numbers_of(PixelFormat::Rgba8Srgb);
    EXPECT_EQ(numbers[3], 1U | 1U << 8U | 2U << 16U);
    EXPECT_EQ(numbers[19], 24U | 7U << 16U | 0x1fU << 24U);
}

// A block of BC5 has two samples of 64 bits.
TEST(DataFormat, DescribesSamplesOfABlock) {
    const std::vector<std::uint32_t> expected = {60,
                                                 0,
                                                 2U | 56U << 16U,
                                                 132U | 1U << 8U | 1U << 16U,
                                                 0x303,
                                                 16,
                                                 0,
                                                 63U << 16U,
                                                 0,
                                                 0,
                                                 0xffffffff,
                                                 64U | 63U << 16U | 1U << 24U,
                                                 0,
                                                 0,
                                                 0xffffffff};
    EXPECT_EQ(numbers_of(PixelFormat::Bc5), expected);
}

}  // namespace
}  // namespace foam::texgen
