#pragma once

#include "texgen/keys/key.h"
#include "texgen/maps/map.h"

namespace foam::texgen {

inline constexpr MapTraits kGrowthMap = {
    .name = "growth",
    .meaning = "how fast bubbles grow, to the next frame",
    .unit = "area per foam time; PNG: 0.5 is 0, ends at growth.full",
    .channels = "Y",
    .png_bits = 16,
    .needs_next = true};

struct GrowthOptions {
    double full = 0.05;  // growth at the largest code of a PNG; its negative is at code 0
};

Keys<GrowthOptions> growth_keys();

/// Draws the growth of every bubble until the next frame: the change of its area over the foam
/// time. A bubble that vanishes loses all its area. Pixels that bubbles share are mixed. Without
/// driving and without a T2 nearby, growth follows von Neumann's law. One channel; 0 around a
/// patch, and everywhere if no time passes. Throws std::invalid_argument without a next frame.
NumberPixels draw_growth(FrameLayers& layers, const GrowthOptions& options);

}  // namespace foam::texgen
