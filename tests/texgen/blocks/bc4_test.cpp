// SPDX-License-Identifier: Apache-2.0

#include "texgen/blocks/bc4.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

namespace foam::texgen {
namespace {

TexelBlock gradient() {
    TexelBlock block{};
    for (std::size_t k = 0; k < block.size(); ++k) {
        const auto step = static_cast<std::uint8_t>(k);
        block[k] = {static_cast<std::uint8_t>(40 + 7 * step),
                    static_cast<std::uint8_t>(255 - 9 * step),
                    77,
                    255};
    }
    return block;
}

// Eight values between the smallest and the largest one are at most half a step away: 7.5 for red,
// whose range is 105, and 9.6 for green, whose range is 135.
TEST(Bc4, StoresRedWithinHalfAStep) {
    const TexelBlock block = gradient();
    const TexelBlock decoded = decode_bc4(encode_bc4(block));
    for (std::size_t k = 0; k < block.size(); ++k) {
        EXPECT_LE(std::abs(decoded[k][0] - block[k][0]), 8);
        EXPECT_EQ(decoded[k][1], 0);
        EXPECT_EQ(decoded[k][3], 255);
    }
}

TEST(Bc4, Bc5StoresRedAndGreenWithinHalfAStep) {
    const TexelBlock block = gradient();
    const TexelBlock decoded = decode_bc5(encode_bc5(block));
    for (std::size_t k = 0; k < block.size(); ++k) {
        EXPECT_LE(std::abs(decoded[k][0] - block[k][0]), 8);
        EXPECT_LE(std::abs(decoded[k][1] - block[k][1]), 10);
        EXPECT_EQ(decoded[k][2], 0);
    }
}

// With endpoints 70 and 0, the values are 70, 0, 60, 50, 40, 30, 20, 10. With endpoints 0 and 50,
// they are 0, 50, 10, 20, 30, 40, 0, 255. The indices of the first texels are 2, 7 and 1.
TEST(Bc4, DecodesBothKindsOfBlocksAsSpecified) {
    const int indices = 2 | 7 << 3 | 1 << 6;
    const auto low = static_cast<std::uint8_t>(indices & 0xff);
    const auto high = static_cast<std::uint8_t>(indices >> 8);
    const TexelBlock eight = decode_bc4(std::array<std::uint8_t, 8>{70, 0, low, high});
    EXPECT_EQ(eight[0][0], 60);
    EXPECT_EQ(eight[1][0], 10);
    EXPECT_EQ(eight[2][0], 0);
    EXPECT_EQ(eight[3][0], 70);
    const TexelBlock six = decode_bc4(std::array<std::uint8_t, 8>{0, 50, low, high});
    EXPECT_EQ(six[0][0], 10);
    EXPECT_EQ(six[1][0], 255);
    EXPECT_EQ(six[2][0], 50);
}

}  // namespace
}  // namespace foam::texgen
