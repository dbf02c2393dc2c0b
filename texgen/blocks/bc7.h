// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/blocks/texel_block.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace foam::texgen {

inline constexpr std::size_t kBc7Bytes = 16;  // bytes of a compressed block

/// Compresses a block of texels as BC7, which is called BPTC in the Khronos Data Format
/// Specification. All channels count equally. A block of a single color is stored exactly. The
/// result uses the modes 1, 5 and 6 of the eight modes of BC7.
std::array<std::uint8_t, kBc7Bytes> encode_bc7(const TexelBlock& texels);

/// Returns the texels of a block in one of the modes that encode_bc7 uses, or nullopt for a block
/// in another mode.
std::optional<TexelBlock> decode_bc7(std::span<const std::uint8_t, kBc7Bytes> block);

}  // namespace foam::texgen
