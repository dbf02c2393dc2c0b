#pragma once

#include "texgen/maps/albedo.h"
#include "texgen/maps/map_image.h"

namespace foam::texgen {

class FrameLayers;

struct RoughnessOptions {
    double cell = 0.15;      // of bubbles, which are smooth and wet
    double film = 0.45;      // of films, as wide as those of albedo
    double variation = 0.1;  // bubbles differ by up to this from each other, each for life
};

/// Roughness of a surface, as materials take it: 0 is a mirror. Mixed by exact area. One channel, 0
/// to 1; 0 around a patch.
NumberPixels draw_roughness(FrameLayers& layers,
                            const RoughnessOptions& options,
                            const AlbedoOptions& films);

}  // namespace foam::texgen
