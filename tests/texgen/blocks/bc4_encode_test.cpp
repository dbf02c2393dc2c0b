// SPDX-License-Identifier: Apache-2.0

#include "tests/support/simd_levels.h"
#include "texgen/blocks/bc4.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <vector>

namespace foam::texgen {
namespace {

TexelBlock decoded(const TexelBlock& block) {
    Bc4Block bytes{};
    encode_bc4({&block, 1}, {&bytes, 1});
    return decode_bc4(bytes);
}

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
TEST(Bc4Encode, Bc5StoresRedAndGreenWithinHalfAStep) {
    const TexelBlock block = gradient();
    Bc5Block bytes{};
    encode_bc5({&block, 1}, {&bytes, 1});
    const TexelBlock found = decode_bc5(bytes);
    for (std::size_t k = 0; k < block.size(); ++k) {
        EXPECT_LE(std::abs(found[k][0] - block[k][0]), 8);
        EXPECT_LE(std::abs(found[k][1] - block[k][1]), 10);
        EXPECT_EQ(found[k][2], 0);
    }
}

TEST(Bc4Encode, EverySingleValueIsExact) {
    for (int value = 0; value < 256; ++value) {
        TexelBlock block{};
        for (auto& texel : block) {
            texel[0] = static_cast<std::uint8_t>(value);
        }
        EXPECT_EQ(decoded(block)[0][0], value);
        EXPECT_EQ(decoded(block)[15][0], value);
    }
}

// Of 0, 255 and the values from 100 to 105, eight values between two endpoints miss most, but six
// values and in addition 0 and 255 are exact.
TEST(Bc4Encode, BlackAndWhiteBesideSimilarValuesAreExact) {
    TexelBlock block{};
    for (std::size_t k = 0; k < block.size(); ++k) {
        block[k][0] = static_cast<std::uint8_t>(k == 3 ? 0 : k == 9 ? 255 : 100 + k % 6);
    }
    const TexelBlock found = decoded(block);
    for (std::size_t k = 0; k < block.size(); ++k) {
        EXPECT_EQ(found[k][0], block[k][0]) << k;
    }
}

// The number of blocks is no multiple of the number of lanes at any level.
TEST(Bc4Encode, AllSimdLevelsGiveTheSameBytes) {
    std::vector<TexelBlock> blocks(203);
    std::uint32_t state = 1;
    for (TexelBlock& block : blocks) {
        for (auto& texel : block) {
            for (std::uint8_t& channel : texel) {
                state = state * 1664525U + 1013904223U;
                channel =
                    static_cast<std::uint8_t>((state >> 16U) % 300U > 255U ? 255U : state >> 24U);
            }
        }
    }
    std::vector<Bc5Block> expected(blocks.size());
    {
        const ForcedSimdLevel forced(SimdLevel::Baseline);
        encode_bc5(blocks, expected);
    }
    at_every_simd_level([&] {
        std::vector<Bc5Block> found(blocks.size());
        encode_bc5(blocks, found);
        EXPECT_EQ(found, expected);
    });
}

}  // namespace
}  // namespace foam::texgen
