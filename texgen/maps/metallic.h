// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/keys/key.h"
#include "texgen/maps/albedo_options.h"
#include "texgen/maps/map.h"

namespace foam::texgen {

inline constexpr MapTraits kMetallicMap = {
    .name = "metallic",
    .meaning = "metalness of bubbles and films: 1 is a metal, 0 is not",
    .unit = "0 to 1",
    .channels = "Y",
    .shows_films = true};

struct MetallicOptions {
    double cell = 0.0;  // metalness of bubbles
    double film = 0.0;  // metalness of films; the options of albedo give their width and shape
};

Keys<MetallicOptions> metallic_keys();

/// Draws the metalness of the surface, as renderers define it in a material: 0 for all materials
/// that are not metals. A pixel that bubbles and films share has the mean of their values, weighted
/// by the part of the pixel that each of them covers. The image has one channel with values from 0
/// to 1 and is 0 around a patch.
NumberPixels draw_metallic(FrameLayers& layers,
                           const MetallicOptions& options,
                           const AlbedoOptions& film_shape);

}  // namespace foam::texgen
