#pragma once

#include "texgen/image/deflate.h"
#include "texgen/image/file_io.h"
#include "texgen/image/picture.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>

namespace foam::texgen {

/// How each row is predicted before compression; the numbers are PNG's.
enum class PngFilter : std::uint8_t { None, Sub, Up, Average, Paeth };

/// How the samples are packed. The pixels do not depend on it.
struct PngEncoding {
    PngFilter filter = PngFilter::None;  // best for flat cells; Up for distance, height, normals
    Compression compression = Compression::Fast;
    int threads = 1;  // that compress, with Compression::Fast; the bytes do not depend on it
};

/// Encodes samples of 8 or 16 bits: 1 channel is grey, 2 grey and alpha, 3 RGB, 4 RGBA with an
/// alpha that is not premultiplied. Rows of a view run upward and rows of a PNG downward; they are
/// flipped here and nowhere else. A color image carries the chunks sRGB (perceptual intent), gAMA
/// and cHRM; `periodic` and `frame_rate` are left out. Throws std::invalid_argument for an empty
/// view, another number of channels, and a keyword that PNG forbids.
Bytes encode_png(ImageView<const std::uint8_t> pixels,
                 const ImageMetadata& metadata = {},
                 const PngEncoding& encoding = {});
Bytes encode_png(ImageView<const std::uint16_t> pixels,
                 const ImageMetadata& metadata = {},
                 const PngEncoding& encoding = {});

/// Encodes a picture of one group of codes. Throws std::invalid_argument for any other picture, and
/// as the functions above.
Bytes encode_png(const Picture& picture, const PngEncoding& encoding = {});

/// Decodes a PNG to one group of 8-bit or 16-bit codes, as the file has them. Palettes and samples
/// of fewer than 8 bits are widened, and a transparent color becomes an alpha channel. Throws
/// InputError for a malformed stream.
Picture decode_png(std::span<const std::byte> content);

/// Encodes and writes a file. Throws as encode_png and write_file do.
void write_png(const std::filesystem::path& path,
               ImageView<const std::uint8_t> pixels,
               const ImageMetadata& metadata = {},
               const PngEncoding& encoding = {});
void write_png(const std::filesystem::path& path,
               ImageView<const std::uint16_t> pixels,
               const ImageMetadata& metadata = {},
               const PngEncoding& encoding = {});

}  // namespace foam::texgen
