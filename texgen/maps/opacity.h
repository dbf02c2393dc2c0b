// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/maps/albedo_options.h"
#include "texgen/maps/map.h"

namespace foam::texgen {

inline constexpr MapTraits kOpacityMap = {
    .name = "opacity",
    .meaning = "coverage by foam, the alpha channel of albedo; 1 everywhere on a torus",
    .unit = "fraction of the pixel, 0 to 1",
    .channels = "Y",
    .shows_films = true};

/// Draws the fraction of every pixel that bubbles and films cover, which is also the alpha channel
/// of the map albedo. The outer films of a patch extend outward by half their width. The image has
/// one channel with values from 0 to 1. It is 1 everywhere on a torus.
NumberPixels draw_opacity(FrameLayers& layers, const AlbedoOptions& options);

}  // namespace foam::texgen
