// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/files/file_io.h"
#include "texgen/image/deflate.h"
#include "texgen/image/picture.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>

namespace foam::texgen {

/// The filter types of PNG. A filter replaces each byte of a row by its difference from a
/// prediction, so that the row compresses better. The values are the same as in the file format.
enum class PngFilter : std::uint8_t { None, Sub, Up, Average, Paeth };

/// Options of filtering and compression. The pixels do not depend on them.
struct PngEncoding {
    // The filter None gives the smallest files for maps in which each bubble has a single color or
    // number. The filter Up or Sub gives the smallest files for smooth maps.
    PngFilter filter = PngFilter::None;
    Compression compression = Compression::Fast;
    /// The number of threads that compress a picture with Compression::Fast; 0 or less means as
    /// many as the hardware runs at once. The other kinds of compression use one thread. The bytes
    /// do not depend on the number of threads.
    int threads = 1;
};

/// Returns samples of 8 or 16 bits encoded as a PNG. One channel is gray, two channels are gray and
/// alpha, three are RGB, and four are RGBA. Colors are not premultiplied by alpha. Rows of a view
/// run upward and rows of a PNG downward, so the encoder reverses their order. If `metadata.color`
/// is set, the file has the chunks sRGB (perceptual intent), gAMA and cHRM. The members
/// `primaries`, `periodic` and `frame_rate` of `metadata` are not stored. Throws OutputError if
/// libpng fails. Throws std::invalid_argument in these cases:
/// - The view is empty.
/// - The number of channels is not from 1 to 4.
/// - The keyword of a text (`metadata.text`) does not have 1 to 79 printable ASCII characters, or
///   has a leading, trailing or double space.
Bytes encode_png(ImageView<const std::uint8_t> pixels,
                 const ImageMetadata& metadata = {},
                 const PngEncoding& encoding = {});
Bytes encode_png(ImageView<const std::uint16_t> pixels,
                 const ImageMetadata& metadata = {},
                 const PngEncoding& encoding = {});

/// Encodes a picture that consists of one ChannelGroup whose samples are integers of 8 or 16 bits
/// (codes). Throws std::invalid_argument for any other picture, and the same exceptions as the
/// functions above.
Bytes encode_png(const Picture& picture, const PngEncoding& encoding = {});

/// Decodes a PNG to a picture of one ChannelGroup of codes. The codes have 16 bits if the file has
/// 16 bits per sample, and 8 bits otherwise. Palettes and samples of fewer than 8 bits are
/// expanded, and a transparent color becomes an alpha channel. The member `color` of the metadata
/// is true if the file has the chunk sRGB. Throws InputError for a malformed stream and for an
/// image above the limits in input_limits.h. Throws OutOfMemory if the machine has too little
/// memory for the image.
Picture decode_png(std::span<const std::byte> content);

/// Encodes samples and writes them to a file. Throws the exceptions of encode_png and write_file.
void write_png(const std::filesystem::path& path,
               ImageView<const std::uint8_t> pixels,
               const ImageMetadata& metadata = {},
               const PngEncoding& encoding = {});
void write_png(const std::filesystem::path& path,
               ImageView<const std::uint16_t> pixels,
               const ImageMetadata& metadata = {},
               const PngEncoding& encoding = {});

}  // namespace foam::texgen
