// SPDX-License-Identifier: Apache-2.0

#include "texgen/blocks/bc7.h"
#include "texgen/blocks/bc7_modes.h"
#include "texgen/blocks/bit_stream.h"

#include <utility>

namespace foam::texgen {

namespace {

using namespace bc7;  // NOLINT(google-build-using-namespace): the facts about the modes

// Two endpoints of 8 bits per channel.
using TwoColors = std::array<std::array<int, 4>, 2>;

int subset_of(int partition, int texel) {
    return kPartitionMasks[static_cast<std::size_t>(partition)] >> texel & 1;
}

TexelBlock decode_mode1(BitReader& bits) {
    const int partition = bits.read(6);
    std::array<TwoColors, 2> subsets{};
    for (std::size_t channel = 0; channel < 3; ++channel) {
        for (TwoColors& ends : subsets) {
            for (std::array<int, 4>& end : ends) {
                end[channel] = bits.read(6);
            }
        }
    }
    for (TwoColors& ends : subsets) {
        const int lowest = bits.read(1);
        for (std::array<int, 4>& end : ends) {
            for (int& value : end) {
                value = expanded7((value << 1) | lowest);
            }
            end[3] = 255;
        }
    }
    TexelBlock texels{};
    for (int k = 0; k < kBlockTexels; ++k) {
        const bool is_anchor = k == 0 || k == kSecondAnchors[static_cast<std::size_t>(partition)];
        const int weight = kWeights3[static_cast<std::size_t>(bits.read(is_anchor ? 2 : 3))];
        const TwoColors& ends = subsets[static_cast<std::size_t>(subset_of(partition, k))];
        for (std::size_t channel = 0; channel < 4; ++channel) {
            texels[static_cast<std::size_t>(k)][channel] =
                static_cast<std::uint8_t>(interpolated(ends[0][channel], ends[1][channel], weight));
        }
    }
    return texels;
}

TexelBlock decode_mode5(BitReader& bits) {
    const int rotation = bits.read(2);
    TwoColors ends{};
    for (std::size_t channel = 0; channel < 4; ++channel) {
        for (std::array<int, 4>& end : ends) {
            end[channel] = channel < 3 ? expanded7(bits.read(7)) : bits.read(8);
        }
    }
    TexelBlock texels{};
    for (const auto& [first, last] : {std::pair(0, 3), std::pair(3, 4)}) {
        for (std::size_t k = 0; k < texels.size(); ++k) {
            const int weight = kWeights2[static_cast<std::size_t>(bits.read(k == 0 ? 1 : 2))];
            for (auto channel = static_cast<std::size_t>(first); static_cast<int>(channel) < last;
                 ++channel) {
                texels[k][channel] = static_cast<std::uint8_t>(
                    interpolated(ends[0][channel], ends[1][channel], weight));
            }
        }
    }
    if (rotation > 0) {
        for (std::array<std::uint8_t, 4>& texel : texels) {
            std::swap(texel[3], texel[static_cast<std::size_t>(rotation - 1)]);
        }
    }
    return texels;
}

TexelBlock decode_mode6(BitReader& bits) {
    TwoColors ends{};
    for (std::size_t channel = 0; channel < 4; ++channel) {
        for (std::array<int, 4>& end : ends) {
            end[channel] = bits.read(7) << 1;
        }
    }
    for (std::array<int, 4>& end : ends) {
        const int lowest = bits.read(1);
        for (int& value : end) {
            value |= lowest;
        }
    }
    TexelBlock texels{};
    for (std::size_t k = 0; k < texels.size(); ++k) {
        const int weight = kWeights4[static_cast<std::size_t>(bits.read(k == 0 ? 3 : 4))];
        for (std::size_t channel = 0; channel < 4; ++channel) {
            texels[k][channel] =
                static_cast<std::uint8_t>(interpolated(ends[0][channel], ends[1][channel], weight));
        }
    }
    return texels;
}

}  // namespace

std::optional<TexelBlock> decode_bc7(std::span<const std::uint8_t, kBc7Bytes> block) {
    BitReader bits(block);
    int mode = 0;
    while (mode < 8 && bits.read(1) == 0) {
        ++mode;
    }
    switch (mode) {
        case 1:
            return decode_mode1(bits);
        case 5:
            return decode_mode5(bits);
        case 6:
            return decode_mode6(bits);
        default:
            return std::nullopt;
    }
}

}  // namespace foam::texgen
