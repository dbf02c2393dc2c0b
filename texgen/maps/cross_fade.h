// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/maps/frame_layers.h"
#include "texgen/maps/map.h"

#include <optional>

namespace foam::texgen {

/// The content of a frame: one foam or, in a cross-fade, two foams.
struct ShownLayers {
    FrameLayers layers;  // the only foam or, in a cross-fade, the foam that fades out
    std::optional<FrameLayers> fading_in = {};  // in a cross-fade, the foam that fades in
};

/// Draws a map of a frame. If the frame contains two foams, draws the map of each foam, and joins
/// both images at the border (FadeBorder). On each side of the border, one foam is shown. In a
/// patch, every pixel without opacity gets the color of nearby pixels (bleed_colors).
MapImage draw(const Map& map, ShownLayers& content, const MapOptions& options);

/// Returns a mixture of two images. `weights` contains for every pixel the weight of the image that
/// fades in, from 0 to 1 (FadeBorder::weights). The image that fades out has the remaining weight.
/// Each channel of colors, the opacity included, is interpolated linearly and independently of the
/// other channels. For numbers, `mixing` selects what is interpolated. Ids are not mixed. A pixel
/// has the id of the image that fades in if the weight is at least 0.5. Otherwise it has the id of
/// the image that fades out. Preconditions: the two images and the weights have the same size; both
/// images are of the same kind and have the same number of channels.
MapImage cross_fade(MapImage fading_out,
                    const MapImage& fading_in,
                    const Image<float>& weights,
                    Mixing mixing);

}  // namespace foam::texgen
