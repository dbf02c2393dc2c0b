// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/deflate.h"
#include "texgen/image/file_io.h"
#include "texgen/image/picture.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>

namespace foam::texgen {

/// The filter types of PNG, which predict each byte of a row before compression. The values are the
/// same as in the file format.
enum class PngFilter : std::uint8_t { None, Sub, Up, Average, Paeth };

/// Filtering and compression of the samples. The pixels do not depend on them.
struct PngEncoding {
    PngFilter filter = PngFilter::None;  // best for flat cells; Up is best for smooth maps
    Compression compression = Compression::Fast;
    int threads = 1;  // threads that compress, if Fast; the bytes do not depend on it
};

/// Encodes samples of 8 or 16 bits: 1 channel is gray, 2 gray and alpha, 3 RGB, 4 RGBA with an
/// alpha that is not premultiplied. Rows of a view run upward and rows of a PNG downward, so the
/// encoder flips them. A color image carries the chunks sRGB (perceptual intent), gAMA and cHRM;
/// `periodic` and `frame_rate` are not stored. Throws std::invalid_argument for an empty view, for
/// other numbers of channels, and for a keyword that PNG forbids. Throws OutputError if libpng
/// fails.
Bytes encode_png(ImageView<const std::uint8_t> pixels,
                 const ImageMetadata& metadata = {},
                 const PngEncoding& encoding = {});
Bytes encode_png(ImageView<const std::uint16_t> pixels,
                 const ImageMetadata& metadata = {},
                 const PngEncoding& encoding = {});

/// Encodes a picture of one group of codes. Throws std::invalid_argument for any other picture, and
/// the exceptions of the functions above.
Bytes encode_png(const Picture& picture, const PngEncoding& encoding = {});

/// Decodes a PNG to one group of codes. The codes have 16 bits if the file has 16 bits per sample,
/// and 8 bits otherwise. Palettes and samples of fewer than 8 bits are expanded, and a transparent
/// color becomes an alpha channel. Throws InputError for a malformed stream.
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
