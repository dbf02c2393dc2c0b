#pragma once

#include "texgen/image/exr.h"
#include "texgen/maps/map.h"
#include "texgen/maps/map_image.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace foam::texgen {

/// What the samples of a map's files are.
struct MapSamples {
    std::string kind;         // "color", "number" or "id"
    std::string channels;     // of the file: "R G B A"; 0 for one that only fills up a PNG
    std::string type;         // "uint8", "uint16", "half", "float" or "uint32"
    std::string color_space;  // "sRGB", "linear sRGB" or "data"
    std::string alpha;        // "none", "straight" or "premultiplied"
    // Of numbers: those that the smallest and the largest code of a PNG stand for. An EXR holds
    // them at neither, and is shown from the one as black to the other as white.
    std::optional<std::array<double, 2>> range;

    friend bool operator==(const MapSamples&, const MapSamples&) = default;
};

/// A map's samples in a PNG of so many bits (8 or 16, colours always 8), or in an EXR that stores
/// numbers as this type.
MapSamples samples_in_png(const Map& map, const MapImage& image, int bits);
MapSamples samples_in_exr(const Map& map, const MapImage& image, ExrType numbers);

/// One image file of a bake.
struct WrittenFile {
    std::filesystem::path path;
    std::vector<std::pair<const Map*, MapSamples>> maps;  // one, or the layers of an EXR
    std::uint64_t bytes = 0;
    std::string pixels;  // pixel_hash
};

}  // namespace foam::texgen
