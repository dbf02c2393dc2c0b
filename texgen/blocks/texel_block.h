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

}  // namespace foam::texgen
