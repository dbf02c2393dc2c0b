#pragma once

#include "texgen/maps/map_image.h"
#include "texgen/maps/relief_options.h"

namespace foam::texgen {

class FrameLayers;

struct OcclusionOptions {
    double strength = 1.0;  // power of the visible part
};

/// Of the light of an even sky, the part that reaches the relief: 1 in the open. It is that of an
/// endless furrow with the section of the relief across the nearest film, the same on both sides.
/// One channel; 1 around a patch.
NumberPixels draw_occlusion(FrameLayers& layers,
                            const ReliefOptions& relief,
                            const OcclusionOptions& options);

}  // namespace foam::texgen
