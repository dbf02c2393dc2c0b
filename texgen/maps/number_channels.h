// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/picture.h"
#include "texgen/maps/map_image.h"

#include <string_view>

namespace foam::texgen {

/// The names of a map's channels in a file of numbers (FormatSamples::Numbers), such as an EXR.
struct ChannelNames {
    // The name of the layer. In the file, this name and a '.' precede the name of each channel, as
    // in "albedo.R". The name is empty if the file has no layers.
    std::string_view layer;
    // The names, separated by spaces, such as "R G B". If the image has one channel more than there
    // are names, the last channel is the opacity and gets the name "A".
    std::string_view channels;
};

/// Returns the image of a map as channels of numbers. Colors become half floats: linear light from
/// 0 to 1, premultiplied by the opacity. Numbers keep their unit and get the sample type
/// `type_of_numbers`. Ids become integers of 32 bits.
ChannelGroup number_channels(MapImage map, const ChannelNames& names, SampleType type_of_numbers);

/// Returns the sample type of the group that number_channels returns for the same arguments.
SampleType number_type(const MapImage& map, SampleType type_of_numbers);

/// Converts samples of colors to linear light from 0 to 1. If the colors have an opacity, red,
/// green and blue are multiplied by it.
Image<float> premultiplied(const ColorPixels& colors);

}  // namespace foam::texgen
