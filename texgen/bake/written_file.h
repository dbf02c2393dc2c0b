// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/format.h"
#include "texgen/maps/drawn_image.h"
#include "texgen/maps/map_image.h"
#include "texgen/maps/number_extent.h"
#include "texgen/preset/output_options.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace foam::texgen {

/// The format of the samples in the files of a map.
struct MapSamples {
    std::string kind;         // "color", "number" or "id"
    std::string channels;     // channels of the file, such as "R G B A"; "0" is a padding channel
    std::string type;         // name of the SampleType, such as "uint8"
    std::string color_space;  // "sRGB", "linear sRGB", "ACEScg" or "data"
    std::string alpha;        // "none", "straight" or "premultiplied"
    // Only for kind "number": the numbers that the smallest and the largest code represent. A code
    // is an integer sample, as a PNG stores it. Formats that store floating-point numbers do not
    // clamp them to this range. Previews show the first number of the range as black and the second
    // number as white.
    std::optional<std::array<double, 2>> range;
    // Only in a file for graphics hardware, such as a DDS: the name of the PixelFormat.
    std::string pixel_format{};

    friend bool operator==(const MapSamples&, const MapSamples&) = default;
};

/// Returns a description of the samples of an image in a file of the given format. `pixels` is the
/// image of any frame. `output` gives the sample type of numbers and the primaries of colors in a
/// format that stores floating-point numbers instead of codes.
MapSamples describe_samples(const DrawnImage& image,
                            const MapImage& pixels,
                            const ImageFormat& format,
                            const OutputOptions& output);

/// Returns the number of bits of each code of an image in the given format; 0 if the format stores
/// floating-point numbers.
int code_bits(const DrawnImage& image, const ImageFormat& format);

/// One file of a bake.
struct WrittenFile {
    std::filesystem::path path;
    // The name of the drawing, table or mesh in a vector file (VectorFormat::parts); empty for
    // images.
    std::string part{};
    // The image that the file stores, or one image per layer; empty for a vector file.
    std::vector<std::pair<DrawnImage, MapSamples>> images;
    std::uint64_t bytes = 0;  // size of the file in bytes
    std::string pixels;       // pixel_hash of the picture, or text_hash of a vector file
    // The extent of the numbers that the codes represent. Only the channels whose map has a key for
    // its range count (DrawnImage::ranged_channels). nullopt if there is no such channel, if the
    // file stores floating-point numbers, or if it is a packing of colors.
    std::optional<NumberExtent> numbers{};
    // A height, as a fraction of the width of the image. In a file of codes, it is the height that
    // the largest code of the map `height` represents. In a file of floating-point numbers, it is
    // the height that the number 1 represents. In a packing, it is the height that the fraction 1
    // of the map `height` represents. In a file of several images, this member describes the first
    // image that contains heights. nullopt if no image contains heights.
    std::optional<double> displacement{};
};

}  // namespace foam::texgen
