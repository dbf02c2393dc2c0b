// SPDX-License-Identifier: Apache-2.0

#include "texgen/blocks/bc7.h"
#include "texgen/blocks/bc7_modes.h"
#include "texgen/blocks/bit_stream.h"

#include <utility>

namespace foam::texgen {

namespace {

using namespace bc7;  // NOLINT(google-build-using-namespace): the facts about the modes

constexpr std::size_t kAlpha = 3;

using EndColors = std::array<std::array<int, 4>, 6>;  // two for each subset
using PerTexel = std::array<int, kBlockTexels>;

EndColors read_ends(const Mode& mode, BitReader& bits) {
    const auto count = 2 * static_cast<std::size_t>(mode.subsets);
    EndColors ends{};
    for (std::size_t channel = 0; channel < 4; ++channel) {
        for (std::size_t k = 0; k < count; ++k) {
            ends[k][channel] = bits.read(channel == kAlpha ? mode.alpha_bits : mode.color_bits);
        }
    }
    return ends;
}

void read_lowest_bits(const Mode& mode, BitReader& bits, EndColors& ends) {
    const auto count = 2 * static_cast<std::size_t>(mode.subsets);
    int lowest = 0;
    for (std::size_t k = 0; mode.lowest != LowestBits::None && k < count; ++k) {
        if (mode.lowest == LowestBits::PerEndpoint || k % 2 == 0) {
            lowest = bits.read(1);
        }
        for (int& code : ends[k]) {
            code = code << 1 | lowest;
        }
    }
}

void expand(const Mode& mode, EndColors& ends) {
    const int lowest = mode.lowest == LowestBits::None ? 0 : 1;
    for (std::array<int, 4>& color : ends) {
        for (std::size_t channel = 0; channel < kAlpha; ++channel) {
            color[channel] = expanded(color[channel], mode.color_bits + lowest);
        }
        color[kAlpha] =
            mode.alpha_bits == 0 ? 255 : expanded(color[kAlpha], mode.alpha_bits + lowest);
    }
}

// Reads an index for each texel. Returns the weights that the indices give to the second endpoint.
PerTexel read_weights(const Mode& mode, int partition, int index_bits, BitReader& bits) {
    PerTexel weights{};
    for (int k = 0; k < kBlockTexels; ++k) {
        const int subset = subset_of(mode.subsets, partition, k);
        const bool is_anchor = k == anchor_of(mode.subsets, partition, subset);
        const int index = bits.read(index_bits - (is_anchor ? 1 : 0));
        weights[static_cast<std::size_t>(k)] = weight_of(index, index_bits);
    }
    return weights;
}

}  // namespace

TexelBlock decode_bc7(std::span<const std::uint8_t, kBc7Bytes> block) {
    TexelBlock texels{};
    BitReader bits(block);
    std::size_t number = 0;
    while (number < kModes.size() && bits.read(1) == 0) {
        ++number;
    }
    if (number == kModes.size()) {
        return texels;
    }
    const Mode& mode = kModes[number];
    const int partition = bits.read(mode.partition_bits);
    const int rotation = bits.read(mode.rotation_bits);
    const bool exchanges_indices = bits.read(mode.selection_bits) == 1;
    EndColors ends = read_ends(mode, bits);
    read_lowest_bits(mode, bits, ends);
    expand(mode, ends);
    PerTexel color = read_weights(mode, partition, mode.index_bits, bits);
    PerTexel alpha = mode.alpha_index_bits > 0
                         ? read_weights(mode, partition, mode.alpha_index_bits, bits)
                         : color;
    if (exchanges_indices) {
        std::swap(color, alpha);
    }
    for (std::size_t k = 0; k < texels.size(); ++k) {
        const auto subset =
            static_cast<std::size_t>(subset_of(mode.subsets, partition, static_cast<int>(k)));
        const std::array<int, 4>& first = ends[2 * subset];
        const std::array<int, 4>& second = ends[2 * subset + 1];
        for (std::size_t channel = 0; channel < 4; ++channel) {
            texels[k][channel] = static_cast<std::uint8_t>(interpolated(
                first[channel], second[channel], channel == kAlpha ? alpha[k] : color[k]));
        }
        if (rotation > 0) {
            std::swap(texels[k][kAlpha], texels[k][static_cast<std::size_t>(rotation - 1)]);
        }
    }
    return texels;
}

}  // namespace foam::texgen
