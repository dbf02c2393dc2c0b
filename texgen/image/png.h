#pragma once

#include "texgen/image/file_io.h"
#include "texgen/image/image.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace foam::texgen {

/// What a PNG says about its samples.
struct PngMetadata {
    /// The samples are sRGB colours: the file carries sRGB (perceptual intent), gAMA and cHRM.
    /// Data, such as a height or an id, carries none of them, so that no reader bends the values.
    bool color = false;
    /// Keyword (1 to 79 printable ASCII characters) and UTF-8 text, in the order of the file.
    std::vector<std::pair<std::string, std::string>> text;
};

/// How each row is predicted before compression. None is smallest for flat cells, Up for distance
/// and height; Adaptive tries all per row and is slow.
enum class PngFilter { None, Sub, Up, Average, Paeth, Adaptive };

/// How the samples are packed; the pixels are the same whatever it says.
struct PngEncoding {
    PngFilter filter = PngFilter::None;
    int compression_level = 6;  // of zlib: 0 stores, 1 is fast, 9 is small
};

/// A picture and what its file said about it.
struct PngImage {
    Image<std::uint8_t> pixels;
    PngMetadata metadata;
};

/// 1 channel is grey, 2 grey and alpha, 3 RGB, 4 RGBA (alpha not premultiplied). The rows of a view
/// run upward, those of a PNG downward: they are turned over here and nowhere else. Throws
/// std::invalid_argument for an empty view, another number of channels or a keyword PNG forbids.
Bytes encode_png(ImageView<const std::uint8_t> pixels,
                 const PngMetadata& metadata = {},
                 const PngEncoding& encoding = {});

/// Undoes encode_png. Palettes and samples of fewer than 8 bits are widened, a transparent colour
/// becomes an alpha channel. Throws InputError for a malformed stream and for 16 bits per sample.
PngImage decode_png(std::span<const std::byte> content);

/// As encode_png and write_file together; throws as they do.
void write_png(const std::filesystem::path& path,
               ImageView<const std::uint8_t> pixels,
               const PngMetadata& metadata = {},
               const PngEncoding& encoding = {});

/// As read_file and decode_png together; the InputError names the file.
PngImage read_png(const std::filesystem::path& path);

}  // namespace foam::texgen
