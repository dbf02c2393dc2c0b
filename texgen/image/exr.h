// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/files/file_io.h"
#include "texgen/image/picture.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <variant>

namespace foam::texgen {

/// One channel of an EXR to be encoded. It refers to its samples, which must outlive it. The
/// samples are floats if `type` is Half or Float, and integers if `type` is Uint32.
struct ExrChannel {
    /// The name in the file, such as "R", or "Y" for a gray image. A name such as "height.Y" is the
    /// channel Y of the layer "height".
    std::string name;
    SampleType type = SampleType::Half;
    std::variant<ImageView<const float>, ImageView<const std::uint32_t>> pixels;
    int channel_index = 0;  // index of this channel among the channels of `pixels`
};

/// The lossless compression methods of EXR. Rle is run-length encoding, Zips and Zip are deflate,
/// and Piz is a wavelet transform with Huffman coding. Rle and Zips compress single rows, Zip
/// compresses blocks of 16 rows, and Piz blocks of 32 rows. In a file of tiles, each method
/// compresses single tiles.
enum class ExrCompression { None, Rle, Zips, Zip, Piz };

/// Options of layout and compression. The pixels do not depend on them.
struct ExrEncoding {
    ExrCompression compression = ExrCompression::Zip;
    /// The level for Zip and Zips, from 1 to 9: 1 and 2 are fastest, 9 gives the smallest files.
    int zip_level = 2;
    /// If true, the file has tiles of 64 x 64 pixels and mip levels down to 1 x 1. Each level has
    /// half the width and height of the level before, rounded down, but at least 1. Floating-point
    /// numbers are averaged by area (mean_level). Integers are ids, which cannot be averaged, so
    /// one of the covered ids is chosen (central_level).
    bool mip_levels = false;
    /// The number of threads that compress; 0 or less means as many as the hardware runs at once.
    /// The bytes do not depend on the number of threads.
    int threads = 1;
};

/// Returns channels encoded as an EXR. Samples are not clamped; samples of Half channels are
/// rounded to half floats. There must be at least one channel and one pixel. All channels must have
/// the same width and height, and distinct names that are not empty. Their order does not matter.
/// By convention colors are linear light, premultiplied by the opacity, which is the channel A.
///
/// If the member `color` of the metadata is true, the attribute `chromaticities` stores the member
/// `primaries`. The attribute `wrapmodes` stores the member `periodic`, and the attribute
/// `framesPerSecond` stores the member `frame_rate`. Each text is stored in a string attribute. The
/// keywords of texts must be distinct and have 1 to 31 characters. They must not be names of
/// attributes that the header has anyway, such as `channels`, or names in the list kReservedNames
/// in exr_encode.cpp.
///
/// Throws std::invalid_argument for channels or texts that break these rules, and for a sample that
/// is not finite or that its type cannot hold. Throws OutputError if OpenEXR fails.
Bytes encode_exr(std::span<const ExrChannel> channels,
                 const ImageMetadata& metadata = {},
                 const ExrEncoding& encoding = {});

/// Encodes a picture of floating-point numbers and 32-bit integers. Throws std::invalid_argument if
/// the picture has codes (SampleType), and the same exceptions as the function above.
Bytes encode_exr(const Picture& picture, const ExrEncoding& encoding = {});

/// Decodes an EXR of rows or tiles. Each channel becomes a ChannelGroup of the picture, in
/// alphabetical order of the channel names. The texts in the metadata of the picture are in
/// alphabetical order of their keywords. Colors whose chromaticities are not close to those of
/// ACEScg are taken for colors with the primaries of sRGB. `level` is the mip level to read; 0 is
/// the full size.
///
/// Throws InputError for a malformed stream, for an image above the limits in input_limits.h, and
/// for a level that does not exist. Also throws it if the file has several parts, or has deep or
/// subsampled channels. Throws OutOfMemory if the machine has too little memory for the image.
Picture decode_exr(std::span<const std::byte> content, int level = 0);

}  // namespace foam::texgen
