// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/image.h"
#include "texgen/maps/map_image.h"

#include <cstdint>
#include <string>

namespace foam::texgen {

/// The number of channels that rgba_from_top returns.
inline constexpr int kRgba = 4;

/// The size of a map's image.
struct MapSize {
    int width = 0;
    int height = 0;
    int channels = 0;
};

/// Returns the size of a map's image.
MapSize size_of(const MapImage& image);

/// Returns a sample of a map as a number in the unit of the map. For a map of colors, the number is
/// linear light or an opacity, from 0 to 1. Row 0 is the bottom row.
float number_of(const MapImage& image, int x, int y, int channel);

/// Returns codes (integers, as in a PNG) of 1 (gray), 3 or 4 channels as red, green, blue and
/// opacity, row by row from the top. The opacity is 255 if there is no fourth channel.
std::string rgba_from_top(const Image<std::uint8_t>& codes);

/// Returns the results of number_of for all samples of a map, as the bytes of 32-bit floats, row by
/// row from the top.
std::string floats_from_top(const MapImage& image);

}  // namespace foam::texgen
