// SPDX-License-Identifier: Apache-2.0

#include "texgen/blocks/bc4.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>

namespace foam::texgen {
namespace {

// With endpoints 70 and 0, the values are 70, 0, 60, 50, 40, 30, 20, 10. With endpoints 0 and 50,
// they are 0, 50, 10, 20, 30, 40, 0, 255. The indices of the first texels are 2, 7 and 1.
TEST(Bc4Decode, BothKindsOfBlocksAreDecodedAsSpecified) {
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

// Red and green are two blocks of one channel. Endpoints of 9 and 8 with the index 1 give 8.
TEST(Bc4Decode, Bc5HasRedFirst) {
    std::array<std::uint8_t, kBc5Bytes> block{};
    block[0] = 200;
    block[8] = 9;
    block[9] = 8;
    block[10] = 1;
    const TexelBlock texels = decode_bc5(block);
    EXPECT_EQ(texels[0], (std::array<std::uint8_t, 4>{200, 8, 0, 255}));
    EXPECT_EQ(texels[1], (std::array<std::uint8_t, 4>{200, 9, 0, 255}));
}

}  // namespace
}  // namespace foam::texgen
