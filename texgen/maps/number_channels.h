// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/picture.h"
#include "texgen/maps/map_image.h"

#include <string_view>

namespace foam::texgen {

/// The names of a map's channels in a file of floats or integers, such as an EXR.
struct ChannelNames {
    std::string_view layer;     // empty for no layer
    std::string_view channels;  // separated by spaces; a further channel is an opacity named A
};

/// Converts a map to channels of numbers. Colors become half floats: linear light from 0 to 1,
/// premultiplied by the opacity. Numbers keep their unit and are stored as the type `numbers`. Ids
/// become integers of 32 bits.
ChannelGroup number_channels(MapImage map, const ChannelNames& names, SampleType numbers);

/// Returns the type of the samples into which number_channels converts a map.
SampleType number_type(const MapImage& map, SampleType numbers);

/// Converts straight colors of 16 bits to linear light from 0 to 1, premultiplied by the opacity.
Image<float> premultiplied(const ColorPixels& colors);

}  // namespace foam::texgen
