// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/blocks/bc7.h"

#include <array>
#include <cstdint>

namespace foam::texgen::bc7 {

/// The two endpoints of a subset. Their values are expanded to 8 bits, as a decoder expands them.
using EndValues = std::array<std::array<std::int32_t, 4>, 2>;

/// An index for each texel.
using Indices = std::array<std::int32_t, kBlockTexels>;

/// The fields of a block.
struct BlockFields {
    int mode = 0;
    int partition = 0;
    int rotation = 0;                 // 1, 2, 3: exchanges alpha with red, green, blue; 0: none
    bool exchanges_indices = false;   // mode 4: true if colors have indices of 3 bits, alpha of 2
    std::array<EndValues, 3> ends{};  // endpoints of each subset
    Indices indices{};                // for all channels or, in the modes 4 and 5, for colors
    Indices alpha_indices{};          // only in the modes 4 and 5
};

/// Returns the block with the given fields. A block does not store the highest bit of the index of
/// an anchor texel (bc7_modes.h); decoders take it as 0. If this bit is 1 in `fields`, this
/// function exchanges the endpoints of the subset. It then replaces each index i of the subset by
/// the largest index minus i. Precondition: the mode can store the values of the endpoints.
Bc7Block pack_bc7(BlockFields fields);

}  // namespace foam::texgen::bc7
