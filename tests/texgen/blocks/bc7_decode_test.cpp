// SPDX-License-Identifier: Apache-2.0

#include "texgen/blocks/bc7.h"
#include "texgen/blocks/bit_stream.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>

namespace foam::texgen {
namespace {

using Texel = std::array<std::uint8_t, 4>;

// A block of mode 6 that is written bit by bit as the specification says: red is 2 x 5 + 1 at the
// first endpoint and 2 x 100 + 0 at the second, and texel 1 has the index 15, all others 0.
TEST(Bc7Decode, Mode6HasOneSubset) {
    BitWriter bits;
    bits.write(1 << 6, 7);
    for (const int code : {5, 100, 0, 0, 0, 0, 127, 127}) {
        bits.write(code, 7);
    }
    bits.write(1, 1);
    bits.write(0, 1);
    bits.write(0, 3);
    bits.write(15, 4);
    const TexelBlock block = decode_bc7(bits.bytes());
    EXPECT_EQ(block[0], (Texel{11, 1, 1, 255}));
    EXPECT_EQ(block[1], (Texel{200, 0, 0, 254}));
    EXPECT_EQ(block[2], block[0]);
}

// In mode 5, the rotation 1 exchanges red and alpha.
TEST(Bc7Decode, Mode5RotatesChannels) {
    BitWriter bits;
    bits.write(1 << 5, 6);
    bits.write(1, 2);
    for (const int code : {127, 0, 64, 0, 0, 0}) {
        bits.write(code, 7);
    }
    bits.write(9, 8);
    bits.write(0, 8);
    const TexelBlock block = decode_bc7(bits.bytes());
    EXPECT_EQ(block[0], (Texel{9, 129, 0, 255}));
}

// Mode 1 with the partition 13, whose second subset is the lower half. 6 bits and a lowest bit per
// subset give 7 bits; the highest bit is repeated below. Red of the first subset: 63 * 2 + 0 = 126,
// 126 * 2 + 126 / 64 = 253. Red of the second subset: 0 and 1, 1 * 2 = 2.
TEST(Bc7Decode, Mode1HasTwoSubsets) {
    BitWriter bits;
    bits.write(1 << 1, 2);
    bits.write(13, 6);
    for (const int code : {63, 0, 0, 0, 0, 0, 0, 63, 0, 0, 0, 0}) {
        bits.write(code, 6);
    }
    bits.write(0, 1);
    bits.write(1, 1);
    bits.write(0, 2);
    bits.write(7, 3);
    const TexelBlock texels = decode_bc7(bits.bytes());
    EXPECT_EQ(texels[0], (Texel{253, 0, 0, 255}));
    EXPECT_EQ(texels[1], (Texel{0, 0, 0, 255}));
    EXPECT_EQ(texels[7], (Texel{253, 0, 0, 255}));
    EXPECT_EQ(texels[8], (Texel{2, 2, 2, 255}));
}

// Mode 2 with the partition 0 of three, whose first row has the subsets 0, 0, 1, 1, and whose last
// row has 2, 2, 2, 2. Codes of 5 bits: 31 stands for 255, 16 for 16 * 8 + 4 = 132. The anchors are
// the texels 0, 3 and 15. The index 1 of texel 12 has the weight 21: (43 * 132 + 32) / 64 = 89.
TEST(Bc7Decode, Mode2HasThreeSubsets) {
    BitWriter bits;
    bits.write(1 << 2, 3);
    bits.write(0, 6);
    for (const int code : {31, 0, 0, 0, 0, 0, 0, 0, 16, 0, 0, 0, 0, 0, 0, 0, 16, 0}) {
        bits.write(code, 5);
    }
    for (int k = 0; k < 12; ++k) {
        bits.write(0, k == 0 || k == 3 ? 1 : 2);
    }
    bits.write(1, 2);
    const TexelBlock texels = decode_bc7(bits.bytes());
    EXPECT_EQ(texels[1], (Texel{255, 0, 0, 255}));
    EXPECT_EQ(texels[2], (Texel{0, 132, 0, 255}));
    EXPECT_EQ(texels[12], (Texel{0, 0, 89, 255}));
    EXPECT_EQ(texels[13], (Texel{0, 0, 132, 255}));
}

// Mode 4 with exchanged indices: those of 3 bits, which follow those of 2 bits, belong to colors.
// The index 7 of texel 1 selects the second endpoint; its index of 2 bits is 0.
TEST(Bc7Decode, Mode4ExchangesIndices) {
    BitWriter bits;
    bits.write(1 << 4, 5);
    bits.write(0, 2);
    bits.write(1, 1);
    for (const int code : {0, 31, 0, 0, 0, 0}) {
        bits.write(code, 5);
    }
    bits.write(63, 6);
    bits.write(0, 6);
    bits.write(0, 31);
    bits.write(0, 2);
    bits.write(7, 3);
    const TexelBlock texels = decode_bc7(bits.bytes());
    EXPECT_EQ(texels[0], (Texel{0, 0, 0, 255}));
    EXPECT_EQ(texels[1], (Texel{255, 0, 0, 255}));
}

TEST(Bc7Decode, ABlockWithoutAModeIsTransparentBlack) {
    Bc7Block block{};
    block[5] = 0xff;
    EXPECT_EQ(decode_bc7(block), TexelBlock{});
}

}  // namespace
}  // namespace foam::texgen
