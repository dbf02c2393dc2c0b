// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace foam::texgen {

inline constexpr int kBlockSide = 4;     // texels
inline constexpr int kBlockTexels = 16;  // texels of a block

/// A square of 4 x 4 texels of red, green, blue and alpha, row by row from the top row.
using TexelBlock = std::array<std::array<std::uint8_t, 4>, kBlockTexels>;

/// Returns true if an image consists of whole blocks. Direct3D allows block compression only for
/// textures whose full size has whole blocks. Their smaller mip levels may have any size.
inline bool has_whole_blocks(int width, int height) {
    return width % kBlockSide == 0 && height % kBlockSide == 0;
}

}  // namespace foam::texgen
