// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/maps/albedo_options.h"
#include "texgen/maps/map.h"

namespace foam::texgen {

inline constexpr MapTraits kFilmMap = {
    .name = "film",
    .meaning = "mask of the films, with the film width of albedo",
    .unit = "fraction of the pixel, 0 to 1",
    .channels = "Y",
    .shows_films = true};

/// Draws the fraction of every pixel that films cover. Films have the width and shape that the
/// options of albedo give; outer films of a patch extend outward by half their width. The image has
/// one channel with values from 0 to 1.
NumberPixels draw_film(FrameLayers& layers, const AlbedoOptions& options);

}  // namespace foam::texgen
