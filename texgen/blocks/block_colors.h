// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/blocks/texel_block.h"

#include <array>
#include <cstddef>

namespace foam::texgen {

/// The channels of a color as numbers from 0 to 255.
using Color = std::array<float, 4>;

/// The two ends of a line of colors.
using Line = std::array<Color, 2>;

/// A set of texels of a block; bit k is set if it contains texel k.
using Subset = unsigned;
inline constexpr Subset kAllTexels = 0xffff;

inline bool has_texel(Subset subset, int texel) {
    return (subset >> static_cast<unsigned>(texel) & 1U) != 0;
}

/// The colors of a block.
struct Colors {
    explicit Colors(const TexelBlock& block) {
        for (std::size_t k = 0; k < block.size(); ++k) {
            for (std::size_t c = 0; c < 4; ++c) {
                texels[k][c] = static_cast<float>(block[k][c]);
            }
            opaque = opaque && block[k][3] == 255;
        }
    }

    std::array<Color, kBlockTexels> texels{};
    bool opaque = true;
};

/// Returns the part of the principal axis of the colors of a subset onto which they are projected.
Line principal_line(const Colors& colors, Subset subset);

}  // namespace foam::texgen
