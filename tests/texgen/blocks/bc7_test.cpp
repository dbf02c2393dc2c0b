// SPDX-License-Identifier: Apache-2.0

#include "texgen/blocks/bc7.h"

#include "texgen/blocks/bit_stream.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

namespace foam::texgen {
namespace {

TexelBlock solid(const std::array<std::uint8_t, 4>& color) {
    TexelBlock block;
    block.fill(color);
    return block;
}

TexelBlock round_trip(const TexelBlock& block) {
    return decode_bc7(encode_bc7(block)).value();
}

// Returns the largest difference between samples of two blocks.
int largest_difference(const TexelBlock& a, const TexelBlock& b) {
    int largest = 0;
    for (std::size_t k = 0; k < a.size(); ++k) {
        for (std::size_t c = 0; c < 4; ++c) {
            largest = std::max(largest, std::abs(a[k][c] - b[k][c]));
        }
    }
    return largest;
}

TEST(Bc7, EverySingleColorIsExact) {
    for (int code = 0; code < 256; ++code) {
        const auto value = static_cast<std::uint8_t>(code);
        const auto other = static_cast<std::uint8_t>(255 - code);
        EXPECT_EQ(round_trip(solid({value, other, value, 255})), solid({value, other, value, 255}));
        EXPECT_EQ(round_trip(solid({0, value, 255, other})), solid({0, value, 255, other}));
    }
}

// Sixteen steps between two colors are the sixteen indices of mode 6.
TEST(Bc7, AGradientIsNearlyExact) {
    TexelBlock block{};
    for (std::size_t k = 0; k < block.size(); ++k) {
        const auto step = static_cast<std::uint8_t>(k);
        block[k] = {static_cast<std::uint8_t>(10 + 3 * step),
                    static_cast<std::uint8_t>(200 - 5 * step),
                    static_cast<std::uint8_t>(90 + step),
                    255};
    }
    EXPECT_LE(largest_difference(round_trip(block), block), 2);
}

TEST(Bc7, OpaqueBlocksStayOpaque) {
    TexelBlock block{};
    for (std::size_t k = 0; k < block.size(); ++k) {
        block[k] = {static_cast<std::uint8_t>(37 * k), static_cast<std::uint8_t>(101 * k), 3, 255};
    }
    for (const std::array<std::uint8_t, 4>& texel : round_trip(block)) {
        EXPECT_EQ(texel[3], 255);
    }
}

// A vertical edge between two gradients of different hues is a partition of mode 1. One line
// between two colors would be far from most of these colors.
TEST(Bc7, TwoGradientsUseTwoSubsets) {
    TexelBlock block{};
    for (std::size_t k = 0; k < block.size(); ++k) {
        const auto step = static_cast<std::uint8_t>(8 * (k / 4));
        block[k] = k % 4 < 2 ? std::array<std::uint8_t, 4>{step, 200, 30, 255}
                             : std::array<std::uint8_t, 4>{250, 20, step, 255};
    }
    const auto bytes = encode_bc7(block);
    EXPECT_EQ(bytes[0] & 3, 2);  // mode 1 begins with the bits 0 and 1
    EXPECT_LE(largest_difference(decode_bc7(bytes).value(), block), 4);
}

TEST(Bc7, AlphaIsStored) {
    TexelBlock block{};
    for (std::size_t k = 0; k < block.size(); ++k) {
        const auto step = static_cast<std::uint8_t>(17 * k);
        block[k] = {step, step, step, step};
    }
    EXPECT_LE(largest_difference(round_trip(block), block), 2);
}

// A block of mode 6 that is written bit by bit as the specification says: red is 2 x 5 + 1 at the
// first endpoint and 2 x 100 + 0 at the second, and texel 1 has the index 15, all others 0.
TEST(Bc7, DecodesMode6AsSpecified) {
    BitWriter bits;
    bits.write(1 << 6, 7);
    for (const int code : {5, 100, 0, 0, 0, 0, 127, 127}) {
        bits.write(code, 7);
    }
    bits.write(1, 1);
    bits.write(0, 1);
    bits.write(0, 3);
    bits.write(15, 4);
    const TexelBlock block = decode_bc7(bits.bytes()).value();
    EXPECT_EQ(block[0], (std::array<std::uint8_t, 4>{11, 1, 1, 255}));
    EXPECT_EQ(block[1], (std::array<std::uint8_t, 4>{200, 0, 0, 254}));
    EXPECT_EQ(block[2], block[0]);
}

// In mode 5, the rotation 1 exchanges red and alpha.
TEST(Bc7, DecodesTheRotationOfMode5) {
    BitWriter bits;
    bits.write(1 << 5, 6);
    bits.write(1, 2);
    for (const int code : {127, 0, 64, 0, 0, 0}) {
        bits.write(code, 7);
    }
    bits.write(9, 8);
    bits.write(0, 8);
    const TexelBlock block = decode_bc7(bits.bytes()).value();
    EXPECT_EQ(block[0], (std::array<std::uint8_t, 4>{9, 129, 0, 255}));
}

TEST(Bc7, OtherModesAreNotDecoded) {
    for (const int mode : {0, 2, 3, 4, 7}) {
        BitWriter bits;
        bits.write(1 << mode, mode + 1);
        EXPECT_FALSE(decode_bc7(bits.bytes())) << mode;
    }
    EXPECT_FALSE(decode_bc7(std::array<std::uint8_t, kBc7Bytes>{}));
}

}  // namespace
}  // namespace foam::texgen
