// SPDX-License-Identifier: Apache-2.0

#include "texgen/blocks/bc4.h"

// Source: Khronos Data Format Specification 1.3, chapter "RGTC Compressed Texture Image Formats". A
// block of one channel has two endpoints of 8 bits, and indices of 3 bits, the first of them in the
// lowest bits.

namespace foam::texgen {

namespace {

// Returns the eight values among which the indices of a block choose. If the first endpoint is not
// the larger one, the last two values are 0 and 255.
std::array<int, 8> palette_of(int first, int second) {
    std::array<int, 8> palette = {first, second, 0, 0, 0, 0, 0, 255};
    const int steps = first > second ? 7 : 5;
    for (int k = 1; k < steps; ++k) {
        palette[static_cast<std::size_t>(k) + 1] =
            ((steps - k) * first + k * second + steps / 2) / steps;
    }
    return palette;
}

void decode_channel(std::span<const std::uint8_t, kBc4Bytes> block,
                    std::size_t channel,
                    TexelBlock& texels) {
    const std::array<int, 8> palette = palette_of(block[0], block[1]);
    std::uint64_t indices = 0;
    for (std::size_t k = block.size() - 1; k >= 2; --k) {
        indices = indices << 8U | block[k];
    }
    for (std::array<std::uint8_t, 4>& texel : texels) {
        texel[channel] = static_cast<std::uint8_t>(palette[indices & 7U]);
        indices >>= 3U;
    }
}

TexelBlock black_block() {
    TexelBlock texels{};
    for (std::array<std::uint8_t, 4>& texel : texels) {
        texel[3] = 255;
    }
    return texels;
}

}  // namespace

TexelBlock decode_bc4(std::span<const std::uint8_t, kBc4Bytes> block) {
    TexelBlock texels = black_block();
    decode_channel(block, 0, texels);
    return texels;
}

TexelBlock decode_bc5(std::span<const std::uint8_t, kBc5Bytes> block) {
    TexelBlock texels = black_block();
    decode_channel(block.first<kBc4Bytes>(), 0, texels);
    decode_channel(block.last<kBc4Bytes>(), 1, texels);
    return texels;
}

}  // namespace foam::texgen
