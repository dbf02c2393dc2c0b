// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/files/file_io.h"
#include "texgen/image/gpu_texture.h"

#include <cstddef>
#include <span>

namespace foam::texgen {

/// Returns a texture as a DDS file (DirectDraw Surface) with the header of Direct3D 10 (DX10),
/// which names the format and the number of layers. Texts are not stored.
Bytes encode_dds(const GpuTexture& texture);

/// Returns the texture in a DDS file. Throws InputError in these cases:
/// - The file is malformed or truncated, or has no header of Direct3D 10.
/// - The format of the texture is not one of PixelFormat.
/// - The texture is a cube or not two-dimensional, or its alpha is premultiplied.
/// - The image is above the limits in core/files/input_limits.h, or there are more than kMaxLayers
///   layers (texture_limits.h).
///
/// Throws OutOfMemory if the machine has too little memory for the texture.
GpuTexture decode_dds(std::span<const std::byte> content);

}  // namespace foam::texgen
