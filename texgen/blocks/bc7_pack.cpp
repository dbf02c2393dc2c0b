// SPDX-License-Identifier: Apache-2.0

#include "texgen/blocks/bc7_pack.h"

#include "texgen/blocks/bc7_modes.h"
#include "texgen/blocks/bit_stream.h"

#include <cstddef>
#include <utility>

namespace foam::texgen::bc7 {

namespace {

// The channels from `first` to `last` - 1, which share indices.
struct IndexedChannels {
    std::size_t first;
    std::size_t last;
    int index_bits;
};

// Makes the highest bit of the index of the subset's anchor texel 0, because a block does not store
// this bit. If the bit is 1, exchanges the endpoints of the subset in the given channels. Each
// index i of the subset then becomes the largest index minus i. The colors stay the same.
void order_ends(BlockFields& fields,
                int subset,
                const IndexedChannels& channels,
                Indices& indices) {
    const int subsets = kModes[static_cast<std::size_t>(fields.mode)].subsets;
    const int largest = (1 << channels.index_bits) - 1;
    const int anchor = anchor_of(subsets, fields.partition, subset);
    if (indices[static_cast<std::size_t>(anchor)] * 2 <= largest) {
        return;
    }
    EndValues& ends = fields.ends[static_cast<std::size_t>(subset)];
    for (std::size_t c = channels.first; c < channels.last; ++c) {
        std::swap(ends[0][c], ends[1][c]);
    }
    for (int k = 0; k < kBlockTexels; ++k) {
        std::int32_t& index = indices[static_cast<std::size_t>(k)];
        index = subset_of(subsets, fields.partition, k) == subset ? largest - index : index;
    }
}

void order_all_ends(const Mode& mode, BlockFields& fields) {
    const bool has_alpha_indices = mode.alpha_index_bits > 0;
    int color_bits = mode.index_bits;
    int alpha_bits = mode.alpha_index_bits;
    if (fields.exchanges_indices) {
        std::swap(color_bits, alpha_bits);
    }
    for (int subset = 0; subset < mode.subsets; ++subset) {
        const IndexedChannels colors{0, has_alpha_indices ? 3U : 4U, color_bits};
        order_ends(fields, subset, colors, fields.indices);
        if (has_alpha_indices) {
            order_ends(fields, subset, {3, 4, alpha_bits}, fields.alpha_indices);
        }
    }
}

void write_ends(const Mode& mode, const BlockFields& fields, BitWriter& bits) {
    const int lowest = mode.lowest == LowestBits::None ? 0 : 1;
    const auto subsets = static_cast<std::size_t>(mode.subsets);
    for (std::size_t c = 0; c < 4; ++c) {
        const int count = c < 3 ? mode.color_bits : mode.alpha_bits;
        for (std::size_t subset = 0; count > 0 && subset < subsets; ++subset) {
            for (const auto& end : fields.ends[subset]) {
                bits.write(end[c] >> (8 - count), count);
            }
        }
    }
    for (std::size_t subset = 0; lowest > 0 && subset < subsets; ++subset) {
        const EndValues& ends = fields.ends[subset];
        const int shift = 7 - mode.color_bits;
        bits.write(ends[0][0] >> shift & 1, 1);
        if (mode.lowest == LowestBits::PerEndpoint) {
            bits.write(ends[1][0] >> shift & 1, 1);
        }
    }
}

void write_indices(
    const Mode& mode, int partition, const Indices& indices, int index_bits, BitWriter& bits) {
    for (int k = 0; k < kBlockTexels; ++k) {
        const int subset = subset_of(mode.subsets, partition, k);
        const bool is_anchor = k == anchor_of(mode.subsets, partition, subset);
        bits.write(indices[static_cast<std::size_t>(k)], index_bits - (is_anchor ? 1 : 0));
    }
}

}  // namespace

Bc7Block pack_bc7(BlockFields fields) {
    const Mode& mode = kModes[static_cast<std::size_t>(fields.mode)];
    order_all_ends(mode, fields);
    BitWriter bits;
    bits.write(1 << fields.mode, fields.mode + 1);
    bits.write(fields.partition, mode.partition_bits);
    bits.write(fields.rotation, mode.rotation_bits);
    bits.write(fields.exchanges_indices ? 1 : 0, mode.selection_bits);
    write_ends(mode, fields, bits);
    if (fields.exchanges_indices) {
        std::swap(fields.indices, fields.alpha_indices);
    }
    write_indices(mode, fields.partition, fields.indices, mode.index_bits, bits);
    if (mode.alpha_index_bits > 0) {
        write_indices(mode, fields.partition, fields.alpha_indices, mode.alpha_index_bits, bits);
    }
    return bits.bytes();
}

}  // namespace foam::texgen::bc7
