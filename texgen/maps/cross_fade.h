#pragma once

#include "texgen/maps/frame_layers.h"
#include "texgen/maps/map.h"

#include <optional>

namespace foam::texgen {

/// The content of a frame: one foam or, in a cross-fade, two, of which one replaces the other.
struct ShownLayers {
    FrameLayers layers;
    std::optional<FrameLayers> rising = {};
    Image<float> shares = {};  // of `rising` in every pixel, from 0 to 1
};

/// Draws a map of a frame.
MapImage draw(const Map& map, ShownLayers& shown, const MapOptions& options);

/// Fades one image into another of the same size and kind; `shares` are those of the other one,
/// from 0 to 1. Colors are mixed as light, without opacity, numbers are mixed, and ids are those of
/// the image with the larger share.
MapImage cross_fade(MapImage falling,
                    const MapImage& rising,
                    const Image<float>& shares,
                    Mixing mixing);

}  // namespace foam::texgen
