// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/keys/key.h"
#include "texgen/maps/map.h"
#include "texgen/maps/relief.h"
#include "texgen/maps/visible_sky.h"

namespace foam::texgen {

inline constexpr MapTraits kOcclusionMap = {
    .name = "occlusion",
    .meaning = "ambient occlusion: fraction of a uniform sky that is visible from the relief",
    .unit = "0 to 1",
    .channels = "Y",
    .png_filter = PngFilter::Up,
    .smooth_images = SmoothImages::Distance,
    .shows_relief = true};

struct OcclusionOptions {
    double strength = 1.0;  // exponent of the visible fraction
};

Keys<OcclusionOptions> occlusion_keys();

/// Draws the fraction of a uniform sky that is visible from the relief, raised to the power
/// options.strength. The fraction is 1 where nothing hides the sky. It is computed as if the
/// nearest film were straight and endless and the relief had the same cross-section everywhere
/// along it (ReliefSection). The image has one channel. Outside of a patch the fraction is 1, with
/// one exception. If the profile of the relief is Ridge or Wet, the films at the rim of the patch
/// rise above their surroundings and hide a part of the sky near them.
NumberPixels draw_occlusion(FrameLayers& layers,
                            const ReliefSource& source,
                            const OcclusionOptions& options);

/// Returns the image of draw_occlusion for an existing relief. `sky` is the lookup of a VisibleSky
/// that was constructed from the section of this relief, from the factor on its heights
/// (ReliefOptions::strength) and from the exponent OcclusionOptions::strength.
Image<float> occlusion_of(const Relief& relief, const SkyLookup& sky);

}  // namespace foam::texgen
