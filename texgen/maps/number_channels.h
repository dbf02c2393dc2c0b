// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/picture.h"
#include "texgen/maps/map_image.h"

#include <string_view>

namespace foam::texgen {

/// The names of a map's channels in a file of floats or integers, such as an EXR.
struct ChannelNames {
    std::string_view layer;     // empty for no layer
    std::string_view channels;  // separated by spaces; an opacity after them is named A
};

/// Permutation a map into channels of numbers. Colors become linear light from 0 to 1,
/// premultiplied by their opacity, as half floats. Numbers keep their unit and have the type
/// `numbers`. Ids become integers of 32 bits.
ChannelGroup number_channels(MapImage map, const ChannelNames& names, SampleType numbers);

/// Returns the type of the samples that number_channels makes of a map.
SampleType number_type(const MapImage& map, SampleType numbers);

/// Permutation straight colors of 16 bits into light from 0 to 1, premultiplied by their opacity.
Image<float> premultiplied(const ColorPixels& colors);

}  // namespace foam::texgen
