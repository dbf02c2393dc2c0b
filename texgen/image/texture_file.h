// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/files/file_io.h"
#include "texgen/image/gpu_texture.h"

#include <cstddef>
#include <span>
#include <string_view>

namespace foam::texgen {

/// A file format for textures of graphics hardware.
struct TextureFormat {
    std::string_view suffix;  // end of its file names, such as ".dds"
    Bytes (*encode)(const GpuTexture& texture) = nullptr;
    /// Throws InputError for a malformed file.
    GpuTexture (*decode)(std::span<const std::byte> content) = nullptr;
};

/// Returns the format whose suffix is the end of the file name, or nullptr if there is none.
const TextureFormat* find_texture_format(std::string_view file_name);

/// Return the content of a file that stores a picture as a texture, and the picture in a file.
/// Throw the exceptions of texture_of, picture_of and the format. `decode_picture` throws
/// InputError for an array of several layers.
Bytes encode_picture(const TextureFormat& format,
                     const Picture& picture,
                     const GpuEncoding& encoding);
Picture decode_picture(const TextureFormat& format, std::span<const std::byte> content);

}  // namespace foam::texgen
