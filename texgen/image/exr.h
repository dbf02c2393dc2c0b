#pragma once

#include "texgen/image/file_io.h"
#include "texgen/image/picture.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <variant>

namespace foam::texgen {

/// One channel of a file that is written. Borrows its samples: floats for Half and Float, integers
/// for Uint32.
struct ExrChannel {
    std::string name;  // "Y" of a grey image, "R", ...; "height.Y" is in the layer "height"
    SampleType type = SampleType::Half;
    std::variant<ImageView<const float>, ImageView<const std::uint32_t>> pixels;
    int channel = 0;  // of the view
};

/// Lossless compressions: Zips packs single rows, Zip 16 rows and Piz 32 rows at a time.
enum class ExrCompression { None, Rle, Zips, Zip, Piz };

/// How the samples are packed. The pixels do not depend on it.
struct ExrEncoding {
    ExrCompression compression = ExrCompression::Zip;
    int zip_level = 2;  // of Zip and Zips: 1 is fast, 9 small
    /// Stores tiles of 64 x 64 in mip levels, each half as wide and high as the level before,
    /// rounded down, to 1 x 1. Numbers are averaged by area; integers are chosen, never mixed.
    bool mip_levels = false;
    int threads = 1;  // that compress; the bytes do not depend on it
};

/// Encodes samples as they are; none is clamped. Channels may come in any order, have one size and
/// different names. By convention colors are light, premultiplied by their opacity, A. Metadata
/// becomes the attributes `chromaticities`, `wrapmodes`, `framesPerSecond` and string attributes,
/// whose names have 1 to 31 characters and no meaning of their own in EXR. Throws
/// std::invalid_argument for channels or texts that break these rules, and for a number that is not
/// finite or that a half cannot hold; OutputError if the library fails.
Bytes encode_exr(std::span<const ExrChannel> channels,
                 const ImageMetadata& metadata = {},
                 const ExrEncoding& encoding = {});

/// Encodes a picture of numbers and integers. Throws std::invalid_argument for codes, and as above.
Bytes encode_exr(const Picture& picture, const ExrEncoding& encoding = {});

/// Decodes a file of rows or tiles to one group per channel, in the order of their names, and texts
/// in alphabetical order. Of a mip-mapped file, reads the given level. Throws InputError for a
/// malformed stream, a level that does not exist, several parts, deep or subsampled channels.
Picture decode_exr(std::span<const std::byte> content, int level = 0);

}  // namespace foam::texgen
