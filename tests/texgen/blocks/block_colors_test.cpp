// SPDX-License-Identifier: Apache-2.0

#include "texgen/blocks/block_colors.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>

namespace foam::texgen {
namespace {

TexelBlock colors_on_a_line() {
    TexelBlock block{};
    for (std::size_t k = 0; k < block.size(); ++k) {
        const auto step = static_cast<std::uint8_t>(k);
        block[k] = {static_cast<std::uint8_t>(10 + 4 * step),
                    static_cast<std::uint8_t>(200 - 8 * step),
                    60,
                    255};
    }
    return block;
}

// The colors are on a line, so the ends of their principal axis are the first and the last color.
TEST(BlockColors, ThePrincipalLineOfColorsOnALineIsThisLine) {
    const Line line = principal_line(Colors(colors_on_a_line()), kAllTexels);
    const bool rises = line[0][0] < line[1][0];
    const Color& first = line[rises ? 0 : 1];
    const Color& last = line[rises ? 1 : 0];
    EXPECT_NEAR(first[0], 10.0, 0.01);
    EXPECT_NEAR(first[1], 200.0, 0.01);
    EXPECT_NEAR(last[0], 70.0, 0.01);
    EXPECT_NEAR(last[1], 80.0, 0.01);
    EXPECT_NEAR(last[2], 60.0, 0.01);
    EXPECT_NEAR(last[3], 255.0, 0.01);
}

TEST(BlockColors, OnlyTexelsOfTheSubsetCount) {
    const Line line = principal_line(Colors(colors_on_a_line()), 1U << 3U);
    EXPECT_NEAR(line[0][0], 22.0, 0.01);
    EXPECT_NEAR(line[1][0], 22.0, 0.01);
}

TEST(BlockColors, ABlockIsOpaqueIfAllTexelsAre) {
    TexelBlock block = colors_on_a_line();
    EXPECT_TRUE(Colors(block).opaque);
    block[7][3] = 254;
    EXPECT_FALSE(Colors(block).opaque);
}

}  // namespace
}  // namespace foam::texgen
