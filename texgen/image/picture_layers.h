// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/picture.h"

#include <string>
#include <vector>

namespace foam::texgen {

/// A layer of a picture: the channels whose names have the same text before the last dot (layer_of
/// in picture.h).
struct PictureLayer {
    std::string name;  // "height" for the channel "height.Y"; empty for channels without a layer
    Picture picture;
};

/// Splits a picture into its layers, in alphabetical order of their names. Every layer gets the
/// metadata of the picture. If no channel has a layer, the result is one layer with an empty name.
/// Precondition: all channels of a ChannelGroup (picture.h) are in the same layer.
std::vector<PictureLayer> split_into_layers(Picture picture);

}  // namespace foam::texgen
