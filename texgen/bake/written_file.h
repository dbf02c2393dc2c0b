#pragma once

#include "texgen/image/format.h"
#include "texgen/maps/all_maps.h"
#include "texgen/maps/map_image.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace foam::texgen {

/// A description of the samples of a map's files.
struct MapSamples {
    std::string kind;         // "color", "number" or "id"
    std::string channels;     // of the file: "R G B A"; 0 for a channel of padding
    std::string type;         // name_of a SampleType
    std::string color_space;  // "sRGB", "linear sRGB" or "data"
    std::string alpha;        // "none", "straight" or "premultiplied"
    // The numbers that the smallest and the largest code stand for. A file of numbers does not
    // clamp to them; previews show the one as black and the other as white.
    std::optional<std::array<double, 2>> range;

    friend bool operator==(const MapSamples&, const MapSamples&) = default;
};

/// Describes a map in a file of a format; `numbers` is the type that files of numbers have.
MapSamples describe_samples(const Map& map,
                            const MapImage& image,
                            const ImageFormat& format,
                            SampleType numbers);

/// Returns the number of bits of a map's codes in a format.
int code_bits(const Map& map, const ImageFormat& format);

/// One image file of a bake.
struct WrittenFile {
    std::filesystem::path path;
    std::vector<std::pair<const Map*, MapSamples>> maps;  // one, or one per layer
    std::uint64_t bytes = 0;
    std::string pixels;  // pixel_hash
};

}  // namespace foam::texgen
