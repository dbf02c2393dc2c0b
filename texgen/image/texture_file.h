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
    /// Throws InputError for a malformed file, and OutOfMemory if the machine has too little memory
    /// for the texture.
    GpuTexture (*decode)(std::span<const std::byte> content) = nullptr;
};

/// Returns the format whose suffix is the end of the file name, or nullptr if there is none.
const TextureFormat* find_texture_format(std::string_view file_name);

/// Returns the content of a file that stores a picture as a texture. Throws the exceptions of
/// texture_of and of TextureFormat::encode.
Bytes encode_picture(const TextureFormat& format,
                     const Picture& picture,
                     const GpuEncoding& encoding);

/// Returns the picture in a file with this content. Throws the exceptions of picture_of and of
/// TextureFormat::decode, and InputError for an array of several layers.
Picture decode_picture(const TextureFormat& format, std::span<const std::byte> content);

}  // namespace foam::texgen
