#pragma once

#include "texgen/image/picture.h"
#include "texgen/maps/map_image.h"

#include <string_view>

namespace foam::texgen {

/// The names of a map's channels in a file of numbers.
struct ChannelNames {
    std::string_view layer;     // empty for no layer
    std::string_view channels;  // separated by spaces; an opacity after them is named A
};

/// Turns a map into channels of numbers: colors become linear light from 0 to 1, premultiplied by
/// their opacity, in half; numbers keep their unit and are stored as `numbers`; ids are integers.
ChannelGroup number_channels(MapImage map, const ChannelNames& names, SampleType numbers);

/// Returns the type that the function above stores a map as.
SampleType number_type(const MapImage& map, SampleType numbers);

/// Turns straight colors of 16 bits into light from 0 to 1, premultiplied by their opacity.
Image<float> premultiplied(const ColorPixels& colors);

}  // namespace foam::texgen
