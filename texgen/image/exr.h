// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/file_io.h"
#include "texgen/image/picture.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <variant>

namespace foam::texgen {

/// One channel of a file to be written. Borrows its samples, which are floats for Half and Float,
/// and integers for Uint32.
struct ExrChannel {
    std::string name;  // "Y" of a gray image, "R", ...; "height.Y" is in the layer "height"
    SampleType type = SampleType::Half;
    std::variant<ImageView<const float>, ImageView<const std::uint32_t>> pixels;
    int channel = 0;  // index in `pixels`
};

/// Lossless compressions: Zips packs single rows, Zip 16 rows and Piz 32 rows at a time.
enum class ExrCompression { None, Rle, Zips, Zip, Piz };

/// Layout and compression of a file. The pixels do not depend on them.
struct ExrEncoding {
    ExrCompression compression = ExrCompression::Zip;
    int zip_level = 2;  // level for Zip and Zips: 1 is the fastest, 9 gives the smallest files
    /// If true, the file has tiles of 64 x 64 pixels and mip levels down to 1 x 1. Each level has
    /// half the width and height of the level before, rounded down. Numbers are averaged by area;
    /// integers are sampled, never mixed.
    bool mip_levels = false;
    int threads = 1;  // number of threads that compress; the bytes do not depend on it
};

/// Encodes samples unchanged, without clamping. All channels must have the same size and distinct
/// names, in any order. By convention colors are linear light, premultiplied by the opacity, which
/// is the channel A. Metadata becomes the attributes `chromaticities`, `wrapmodes`,
/// `framesPerSecond` and string attributes. Names of string attributes must have 1 to 31 characters
/// and must not be names of standard attributes of EXR. Throws std::invalid_argument for channels
/// or texts that break these rules, and for a number that is not finite or that its type cannot
/// hold. Throws OutputError if OpenEXR fails.
Bytes encode_exr(std::span<const ExrChannel> channels,
                 const ImageMetadata& metadata = {},
                 const ExrEncoding& encoding = {});

/// Encodes a picture of numbers and 32-bit integers. Throws std::invalid_argument if the picture
/// has codes, and the exceptions of the function above.
Bytes encode_exr(const Picture& picture, const ExrEncoding& encoding = {});

/// Decodes a file of rows or tiles. The picture has one group per channel, in the order of the
/// channel names, and its texts are in alphabetical order. `level` is the mip level to read. Throws
/// InputError for a malformed stream, for a level that does not exist, and if the file has several
/// parts or has deep or subsampled channels.
Picture decode_exr(std::span<const std::byte> content, int level = 0);

}  // namespace foam::texgen
