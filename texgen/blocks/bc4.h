// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/blocks/texel_block.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace foam::texgen {

inline constexpr std::size_t kBc4Bytes = 8;   // bytes of a compressed block of one channel
inline constexpr std::size_t kBc5Bytes = 16;  // bytes of a compressed block of two channels

using Bc4Block = std::array<std::uint8_t, kBc4Bytes>;
using Bc5Block = std::array<std::uint8_t, kBc5Bytes>;

/// Compress the red channel of blocks as BC4 (called RGTC in the Khronos Data Format
/// Specification), or the red and the green channel as BC5. Blocks of a single value are stored
/// exactly. The result of a block depends neither on other blocks nor on the SIMD level. Many
/// blocks at once are faster than one at a time. Precondition: `blocks` has as many elements as
/// `texels`.
void encode_bc4(std::span<const TexelBlock> texels, std::span<Bc4Block> blocks);
void encode_bc5(std::span<const TexelBlock> texels, std::span<Bc5Block> blocks);

/// Return the texels of a block. Channels that the format does not store are 0, and alpha is 255.
TexelBlock decode_bc4(std::span<const std::uint8_t, kBc4Bytes> block);
TexelBlock decode_bc5(std::span<const std::uint8_t, kBc5Bytes> block);

}  // namespace foam::texgen
