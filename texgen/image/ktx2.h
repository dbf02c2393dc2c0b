// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/files/file_io.h"
#include "texgen/image/gpu_texture.h"

#include <cstddef>
#include <span>

namespace foam::texgen {

/// Returns a texture as a KTX 2.0 file (Khronos Texture), whose mip levels are compressed with
/// Zstandard. The texts are stored as key/value data. For an array with an animation
/// (GpuTexture::animation), the frame rate and the repetition are stored there, too. On one
/// machine, equal textures give equal bytes. Throws OutputError if Zstandard fails.
Bytes encode_ktx2(const GpuTexture& texture);

/// Returns the texture in a KTX 2.0 file. Throws OutOfMemory if the machine has too little memory
/// for the texture. Throws InputError in these cases:
/// - The file is malformed or truncated.
/// - The pixel format is not one of PixelFormat.
/// - The texture is a cube or a volume.
/// - The data are not compressed with Zstandard.
/// - The alpha of the texture is premultiplied.
/// - The image is above the limits in core/files/input_limits.h, or there are more than kMaxLayers
///   layers (texture_limits.h).
/// - A mip level of all layers has more than 4 GiB.
GpuTexture decode_ktx2(std::span<const std::byte> content);

}  // namespace foam::texgen
