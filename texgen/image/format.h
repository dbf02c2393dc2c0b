// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/exr.h"
#include "texgen/image/file_io.h"
#include "texgen/image/picture.h"
#include "texgen/image/png.h"

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace foam::texgen {

/// The encoding options of all formats. Each format reads its own; none of them changes a pixel.
struct EncodingOptions {
    PngEncoding png = {};
    ExrEncoding exr = {};
};

/// The kind of samples that a format stores.
enum class FormatSamples {
    Codes,    // one group of 1 to 4 interleaved channels of integer codes; colors as sRGB
    Numbers,  // any number of named channels of numbers or ids; colors as premultiplied light
};

/// A still-image format: all that the rest of the program uses of it. README.md explains how to add
/// one.
struct ImageFormat {
    std::string_view name;    // as messages call it: "PNG"
    std::string_view suffix;  // of its file names: ".png"
    FormatSamples samples = FormatSamples::Codes;
    int code_bits = 0;        // the largest number of bits of a code; 0 for numbers
    bool has_layers = false;  // one file can hold several maps
    Bytes (*encode)(const Picture& picture, const EncodingOptions& options) = nullptr;
    Picture (*decode)(std::span<const std::byte> content) = nullptr;  // throws InputError
};

/// All formats.
std::span<const ImageFormat> image_formats();

/// Returns the format whose suffix ends the name, or nullptr.
const ImageFormat* find_format(std::string_view file_name);

/// Return the suffixes and the names of all formats, for messages: ".png or .exr", "PNG or EXR".
std::string format_suffixes();
std::string format_names();

/// Reads a file of any format. Throws InputError, whose message names the file, if the file is
/// unreadable or malformed, or if its suffix is not that of a format.
Picture read_picture(const std::filesystem::path& path);

}  // namespace foam::texgen
