// SPDX-License-Identifier: Apache-2.0

#include "tests/support/simd_levels.h"
#include "texgen/blocks/bc7.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <vector>

namespace foam::texgen {
namespace {

TexelBlock solid(const std::array<std::uint8_t, 4>& color) {
    TexelBlock block;
    block.fill(color);
    return block;
}

Bc7Block encoded(const TexelBlock& block) {
    Bc7Block bytes{};
    encode_bc7({&block, 1}, {&bytes, 1});
    return bytes;
}

TexelBlock round_trip(const TexelBlock& block) {
    return decode_bc7(encoded(block));
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

TEST(Bc7Encode, EverySingleColorIsExact) {
    for (int code = 0; code < 256; ++code) {
        const auto value = static_cast<std::uint8_t>(code);
        const auto other = static_cast<std::uint8_t>(255 - code);
        EXPECT_EQ(round_trip(solid({value, other, value, 255})), solid({value, other, value, 255}));
        EXPECT_EQ(round_trip(solid({0, value, 255, other})), solid({0, value, 255, other}));
    }
}

// Sixteen steps between two colors are the sixteen indices of mode 6.
TEST(Bc7Encode, AGradientIsNearlyExact) {
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

TEST(Bc7Encode, OpaqueBlocksStayOpaque) {
    TexelBlock block{};
    for (std::size_t k = 0; k < block.size(); ++k) {
        block[k] = {static_cast<std::uint8_t>(37 * k), static_cast<std::uint8_t>(101 * k), 3, 255};
    }
    for (const std::array<std::uint8_t, 4>& texel : round_trip(block)) {
        EXPECT_EQ(texel[3], 255);
    }
}

// Red takes only values that mode 5 stores exactly with indices of its own, so alpha takes its
// place beside green and blue. These first have the same endpoints, so that all indices are 0 and
// the second endpoint does not count.
TEST(Bc7Encode, AlphaStays255IfOneEndpointDoesNotCount) {
    const TexelBlock block = {{{255, 143, 193, 255},
                               {0, 143, 194, 255},
                               {255, 141, 193, 255},
                               {255, 143, 193, 255},
                               {255, 143, 194, 255},
                               {85, 142, 193, 255},
                               {255, 143, 193, 255},
                               {0, 142, 194, 255},
                               {0, 142, 194, 255},
                               {85, 142, 192, 255},
                               {170, 142, 194, 255},
                               {0, 143, 193, 255},
                               {0, 142, 192, 255},
                               {255, 142, 194, 255},
                               {0, 143, 192, 255},
                               {0, 143, 193, 255}}};
    const Bc7Block bytes = encoded(block);
    EXPECT_EQ(bytes[0] & 0x3f, 1 << 5);
    for (const std::array<std::uint8_t, 4>& texel : decode_bc7(bytes)) {
        EXPECT_EQ(texel[3], 255);
    }
}

// A vertical edge between two gradients of different hues is a partition of the modes 1 and 3. One
// line between two colors would be far from most of these colors.
TEST(Bc7Encode, TwoGradientsUseTwoSubsets) {
    TexelBlock block{};
    for (std::size_t k = 0; k < block.size(); ++k) {
        const auto step = static_cast<std::uint8_t>(8 * (k / 4));
        block[k] = k % 4 < 2 ? std::array<std::uint8_t, 4>{step, 200, 30, 255}
                             : std::array<std::uint8_t, 4>{250, 20, step, 255};
    }
    const Bc7Block bytes = encoded(block);
    EXPECT_TRUE((bytes[0] & 3) == 2 || (bytes[0] & 15) == 8) << int{bytes[0]};
    EXPECT_LE(largest_difference(decode_bc7(bytes), block), 4);
}

TEST(Bc7Encode, AlphaIsStored) {
    TexelBlock block{};
    for (std::size_t k = 0; k < block.size(); ++k) {
        const auto step = static_cast<std::uint8_t>(17 * k);
        block[k] = {step, step, step, step};
    }
    EXPECT_LE(largest_difference(round_trip(block), block), 2);
}

// Texels of independent channels: two of them have indices of their own in mode 5.
TEST(Bc7Encode, IndependentChannelsUseMode5) {
    TexelBlock block{};
    for (std::size_t k = 0; k < block.size(); ++k) {
        block[k] = {static_cast<std::uint8_t>(80 * (k % 4)),
                    static_cast<std::uint8_t>(80 * (k / 4)),
                    20,
                    255};
    }
    const Bc7Block bytes = encoded(block);
    EXPECT_EQ(bytes[0] & 0x3f, 1 << 5);
    EXPECT_LE(largest_difference(decode_bc7(bytes), block), 3);
}

// Few colors, and an opacity of many values that does not depend on them: mode 4 has the most
// indices for the opacity. It stores colors with 5 bits.
TEST(Bc7Encode, AnOpacityOfManyValuesUsesMode4) {
    TexelBlock block{};
    for (std::size_t k = 0; k < block.size(); ++k) {
        const std::uint8_t color = k % 2 == 0 ? 0 : 255;
        block[k] = {color, color, color, static_cast<std::uint8_t>(255 / 7 * (k / 2))};
    }
    const Bc7Block bytes = encoded(block);
    EXPECT_EQ(bytes[0] & 0x1f, 1 << 4);
    EXPECT_LE(largest_difference(decode_bc7(bytes), block), 4);
}

// The opacity has few values, and the colors have many. Mode 4 with exchanged indices has the most
// indices for the colors.
TEST(Bc7Encode, ColorsOfManyValuesUseMode4) {
    TexelBlock block{};
    for (std::size_t k = 0; k < block.size(); ++k) {
        const auto color = static_cast<std::uint8_t>(255 / 7 * (k / 2));
        block[k] = {color, color, color, static_cast<std::uint8_t>(k % 2 == 0 ? 0 : 255)};
    }
    const Bc7Block bytes = encoded(block);
    EXPECT_EQ(bytes[0] & 0x1f, 1 << 4);
    EXPECT_LE(largest_difference(decode_bc7(bytes), block), 8);
}

// Three stripes, each of a color of its own with small differences, are subsets of a partition of
// three. Two lines between colors cannot approximate three clusters that are not on a line.
TEST(Bc7Encode, ThreeColorsUseThreeSubsets) {
    TexelBlock block{};
    for (std::size_t k = 0; k < block.size(); ++k) {
        const auto step = static_cast<std::uint8_t>(9 * (k % 4));
        const std::size_t row = k / 4;
        block[k] = row == 0   ? std::array<std::uint8_t, 4>{step, 200, 30, 255}
                   : row == 1 ? std::array<std::uint8_t, 4>{250, 20, step, 255}
                              : std::array<std::uint8_t, 4>{40, step, 255, 255};
    }
    const Bc7Block bytes = encoded(block);
    EXPECT_TRUE((bytes[0] & 1) == 1 || (bytes[0] & 7) == 4) << int{bytes[0]};
    EXPECT_LE(largest_difference(decode_bc7(bytes), block), 8);
}

// Returns blocks of smooth colors with edges, from a linear congruential generator. Every fourth
// block has alpha, and every eighth one a single color.
std::vector<TexelBlock> many_blocks(std::size_t count) {
    std::uint32_t state = 1;
    const auto next = [&](std::uint32_t below) {
        state = state * 1664525U + 1013904223U;
        return (state >> 16U) % below;
    };
    std::vector<TexelBlock> blocks(count);
    for (std::size_t number = 0; number < count; ++number) {
        std::array<std::array<std::uint32_t, 4>, 2> colors{};
        for (auto& color : colors) {
            color = {next(256), next(256), next(256), number % 4 == 0 ? next(256) : 255};
        }
        const std::uint32_t edge = next(5);
        const std::uint32_t noise = number % 8 == 0 ? 1 : 1 + next(20);
        for (std::size_t k = 0; k < kBlockTexels; ++k) {
            const auto& color = colors[k % 4 < edge && number % 8 != 0 ? 1 : 0];
            for (std::size_t c = 0; c < 4; ++c) {
                const std::uint32_t added = c < 3 || color[3] < 255 ? next(noise) : 0;
                blocks[number][k][c] = static_cast<std::uint8_t>(std::min(255U, color[c] + added));
            }
        }
    }
    return blocks;
}

// The number of blocks is no multiple of the number of lanes at any level.
TEST(Bc7Encode, AllSimdLevelsGiveTheSameBytes) {
    const std::vector<TexelBlock> blocks = many_blocks(203);
    std::vector<Bc7Block> expected(blocks.size());
    {
        const ForcedSimdLevel forced(SimdLevel::Baseline);
        encode_bc7(blocks, expected);
    }
    at_every_simd_level([&] {
        std::vector<Bc7Block> found(blocks.size());
        encode_bc7(blocks, found);
        EXPECT_EQ(found, expected);
    });
}

TEST(Bc7Encode, ABlockDoesNotDependOnOthers) {
    const std::vector<TexelBlock> blocks = many_blocks(65);
    std::vector<Bc7Block> together(blocks.size());
    encode_bc7(blocks, together);
    for (std::size_t k = 0; k < blocks.size(); ++k) {
        EXPECT_EQ(encoded(blocks[k]), together[k]) << k;
    }
}

// Noise of up to 20 around two colors, in three or four independent channels. The measured mean
// squared error is 2.77.
TEST(Bc7Encode, TheErrorOfManyBlocksIsSmall) {
    const std::vector<TexelBlock> blocks = many_blocks(4000);
    std::vector<Bc7Block> stored(blocks.size());
    encode_bc7(blocks, stored);
    double sum = 0.0;
    for (std::size_t number = 0; number < blocks.size(); ++number) {
        const TexelBlock decoded = decode_bc7(stored[number]);
        for (std::size_t k = 0; k < kBlockTexels; ++k) {
            for (std::size_t c = 0; c < 4; ++c) {
                const double difference = decoded[k][c] - blocks[number][k][c];
                sum += difference * difference;
            }
        }
    }
    EXPECT_LT(sum / (64.0 * static_cast<double>(blocks.size())), 2.8);
}

}  // namespace
}  // namespace foam::texgen
