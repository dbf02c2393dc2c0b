// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/blocks/texel_block.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace foam::texgen {

inline constexpr std::size_t kBc7Bytes = 16;  // bytes of a compressed block

using Bc7Block = std::array<std::uint8_t, kBc7Bytes>;

/// Compresses blocks of texels as BC7, which is called BPTC in the Khronos Data Format
/// Specification. Errors of all channels count equally. Blocks of a single color are stored
/// exactly, and opaque blocks stay opaque. The result of a block depends neither on other blocks
/// nor on the SIMD level. Compressing many blocks in one call is faster than compressing them one
/// by one. Precondition: `blocks` has as many elements as `texels`.
void encode_bc7(std::span<const TexelBlock> texels, std::span<Bc7Block> blocks);

/// Returns the texels of a block. A block whose first byte is 0 has no mode and gives transparent
/// black.
TexelBlock decode_bc7(std::span<const std::uint8_t, kBc7Bytes> block);

}  // namespace foam::texgen
