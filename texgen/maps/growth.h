// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/keys/key.h"
#include "texgen/keys/value_kinds.h"
#include "texgen/maps/map.h"

namespace foam::texgen {

inline constexpr MapTraits kGrowthMap = {
    .name = "growth",
    .meaning = "growth rate of bubbles, to the next frame",
    .unit = "area per foam time; in a PNG, 0.5 stands for 0, and 1 stands for growth.full",
    .channels = "Y",
    .png_bits = 16,
    .needs_next = true,
    .full_key = "growth.full"};

struct GrowthOptions {
    // The growth rate that a PNG stores as its largest code (65535), in square foam units per foam
    // time. Code 0 stands for -full.
    AutoReal full{0.05, true};
};

Keys<GrowthOptions> growth_keys();

/// Draws the growth rate of every bubble: the change of its area until the next frame, divided by
/// the magnitude of the change of foam time. A bubble that vanishes before the next frame has the
/// area 0 in that frame. A pixel that several bubbles share has the mean of their rates, weighted
/// by the part of the pixel that each bubble covers. In the second half of a pingpong loop, time
/// runs backwards. A bubble that shrinks from frame to frame has a negative rate in these frames,
/// too. In all other frames, a rate follows von Neumann's law (E6 in core/EQUATIONS.md) under two
/// conditions. Diffusion alone must change the area of the bubble, and its number of sides must
/// stay the same. The image has one channel. It is 0 around a patch. If no time passes until the
/// next frame, it is 0 everywhere. Throws std::invalid_argument if there is no next frame.
NumberPixels draw_growth(FrameLayers& layers, const GrowthOptions& options);

}  // namespace foam::texgen
