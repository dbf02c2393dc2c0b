// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/keys/key.h"
#include "texgen/maps/albedo_options.h"
#include "texgen/maps/map.h"

namespace foam::texgen {

inline constexpr MapTraits kRoughnessMap = {
    .name = "roughness",
    .meaning = "surface roughness: bubbles are smoother than films and vary slightly",
    .unit = "0 to 1",
    .channels = "Y",
    .shows_films = true};

struct RoughnessOptions {
    double cell = 0.15;  // roughness of bubbles, which are smooth and wet
    double film = 0.45;  // roughness of films; AlbedoOptions has the width and the shape of films
    // The roughness of bubbles is from `cell` - `variation` / 2 to `cell` + `variation` / 2,
    // clamped to [0, 1].
    double variation = 0.1;
};

Keys<RoughnessOptions> roughness_keys();

/// Draws the roughness of the surface, as renderers define it in a material: 0 is a mirror. A pixel
/// that bubbles and films share has the mean of their values, weighted by the part of the pixel
/// that each bubble or film covers. The image has one channel with values from 0 to 1 and is 0
/// around a patch.
NumberPixels draw_roughness(FrameLayers& layers,
                            const RoughnessOptions& options,
                            const AlbedoOptions& films);

}  // namespace foam::texgen
