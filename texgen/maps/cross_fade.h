// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/maps/frame_layers.h"
#include "texgen/maps/map.h"

#include <optional>

namespace foam::texgen {

/// The content of a frame: one foam or, in a cross-fade, two foams. The rising foam replaces the
/// other one.
struct ShownLayers {
    FrameLayers layers;
    std::optional<FrameLayers> rising = {};
    Image<float> weights = {};  // weight of `rising` in every pixel, from 0 to 1
};

/// Draws a map of a frame, and cross-fades the maps of both foams if there are two.
MapImage draw(const Map& map, ShownLayers& shown, const MapOptions& options);

/// Fades an image into a rising one of the same size and kind. `weights` holds the weight of the
/// rising image in every pixel, from 0 to 1. Every channel of colors, opacity included, is mixed
/// linearly by itself. Numbers are mixed by value or by slope. Ids are not mixed: each pixel takes
/// the id of the image with the larger weight.
MapImage cross_fade(MapImage falling,
                    const MapImage& rising,
                    const Image<float>& weights,
                    Mixing mixing);

}  // namespace foam::texgen
