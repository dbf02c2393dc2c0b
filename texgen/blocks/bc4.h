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

/// Compresses the red channel of a block as BC4 (called RGTC in the Khronos Data Format
/// Specification), or the red and the green channel as BC5. The library libsquish does the work.
std::array<std::uint8_t, kBc4Bytes> encode_bc4(const TexelBlock& texels);
std::array<std::uint8_t, kBc5Bytes> encode_bc5(const TexelBlock& texels);

/// Return the texels of a block. Channels that the format does not store are 0, and alpha is 255.
TexelBlock decode_bc4(std::span<const std::uint8_t, kBc4Bytes> block);
TexelBlock decode_bc5(std::span<const std::uint8_t, kBc5Bytes> block);

}  // namespace foam::texgen
