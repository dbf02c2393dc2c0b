// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/files/file_io.h"
#include "texgen/image/exr.h"
#include "texgen/image/gpu_texture.h"
#include "texgen/image/picture.h"
#include "texgen/image/png.h"

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace foam::texgen {

/// The encoding options of all formats. Each format reads only its own options. Only the block
/// compression of textures (GpuEncoding::blocks) changes pixels.
struct EncodingOptions {
    PngEncoding png = {};
    ExrEncoding exr = {};
    GpuEncoding gpu = {};
};

/// The kind of samples that a format stores.
enum class FormatSamples {
    /// One group of 1, 3 or 4 interleaved channels of codes: integers of 8 or 16 bits whose largest
    /// value represents 1. A PNG may also have two channels. Colors are sRGB.
    Codes,
    /// Any number of named channels of floating-point numbers or 32-bit integers. Colors are linear
    /// light, premultiplied by the opacity.
    Numbers,
};

/// A still-image format. Baked images are written and read only through this interface. README.md
/// explains how to add a format.
struct ImageFormat {
    std::string_view name;    // name in messages, such as "PNG"
    std::string_view suffix;  // end of its file names, such as ".png"
    FormatSamples samples = FormatSamples::Codes;
    int code_bits = 0;        // the largest number of bits of a code; 0 for numbers
    bool has_layers = false;  // true if one file can store several maps
    bool is_lossy = false;    // true if a decoded picture may differ from the encoded one

    /// Returns the content of a file that stores the picture. Throws std::invalid_argument if the
    /// format cannot store the picture, and OutputError if encoding fails.
    Bytes (*encode)(const Picture& picture, const EncodingOptions& options) = nullptr;
    /// Returns the picture that a file with this content stores. Throws InputError if the content
    /// is malformed, and OutOfMemory if the machine has too little memory for the picture.
    Picture (*decode)(std::span<const std::byte> content) = nullptr;
};

/// Returns all formats.
std::span<const ImageFormat> image_formats();

/// Returns the format whose suffix is the end of the file name, or nullptr if there is none.
const ImageFormat* find_format(std::string_view file_name);

/// Return the suffixes of all formats, such as ".png or .exr", and their names, such as "PNG or
/// EXR", for messages.
std::string format_suffixes();
std::string format_names();

/// Returns decode(content) for the content of an image file. Throws InputError, whose message names
/// the file, if the file is unreadable or if `decode` throws InputError.
template <class Decode>
auto decode_file(const std::filesystem::path& path, const Decode& decode) {
    const Bytes content = read_file(path, kImageInput);
    try {
        return decode(content);
    } catch (const InputError& error) {
        fail_to_read(path, error.what());
    }
}

/// Reads a file of any format. Throws InputError, whose message names the file, if the file is
/// unreadable or malformed, or if no format has its suffix. Throws OutOfMemory if the machine has
/// too little memory for the picture.
Picture read_picture(const std::filesystem::path& path);

}  // namespace foam::texgen
