// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/keys/key.h"
#include "texgen/maps/map.h"
#include "texgen/maps/relief_options.h"

namespace foam::texgen {

inline constexpr MapTraits kOcclusionMap = {
    .name = "occlusion",
    .meaning = "ambient occlusion: fraction of a uniform sky that is visible from the relief",
    .unit = "0 to 1",
    .channels = "Y",
    .png_filter = PngFilter::Up,
    .smooth_distance = SmoothDistance::Used,
    .around = 1.0};

struct OcclusionOptions {
    double strength = 1.0;  // exponent of the visible fraction
};

Keys<OcclusionOptions> occlusion_keys();

/// Draws the fraction of a uniform sky that is visible from the relief, to the power of
/// options.strength. It is 1 in the open. The fraction is computed for an endless furrow whose
/// cross-section is the section of the relief across the nearest film (ReliefSection). The image
/// has one channel and is 1 away from a patch.
NumberPixels draw_occlusion(FrameLayers& layers,
                            const ReliefOptions& relief,
                            const OcclusionOptions& options);

}  // namespace foam::texgen
