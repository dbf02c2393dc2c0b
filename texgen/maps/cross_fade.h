#pragma once

#include "texgen/maps/frame_layers.h"
#include "texgen/maps/map.h"

#include <optional>

namespace foam::texgen {

/// What a frame shows: one foam or, in a cross-fade, two, of which the other takes its place.
struct ShownLayers {
    FrameLayers layers;
    std::optional<FrameLayers> rising = {};
    Image<float> shares = {};  // of `rising` in every pixel, from 0 to 1
};

/// Draws a map of a frame.
MapImage draw(const Map& map, ShownLayers& shown, const MapOptions& options);

/// One image on its way into another of the same size and kind, of which every pixel has a share
/// from 0 to 1: colours as light, without opacity, and numbers are mixed, ids are those of the one
/// with the larger share.
MapImage cross_fade(MapImage falling,
                    const MapImage& rising,
                    const Image<float>& shares,
                    Mixing mixing);

}  // namespace foam::texgen
