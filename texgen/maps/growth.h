// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/keys/key.h"
#include "texgen/maps/map.h"

namespace foam::texgen {

inline constexpr MapTraits kGrowthMap = {
    .name = "growth",
    .meaning = "growth rate of bubbles, to the next frame",
    .unit = "area per foam time; PNG: 0.5 is 0, 1 is growth.full",
    .channels = "Y",
    .png_bits = 16,
    .needs_next = true};

struct GrowthOptions {
    double full = 0.05;  // growth stored as the largest code of a PNG; code 0 is its negative
};

Keys<GrowthOptions> growth_keys();

/// Draws the growth of every bubble until the next frame: the change of its area per foam time. A
/// bubble that vanishes loses all its area. A pixel that several bubbles share has the mean of
/// their values, weighted by area. Growth follows von Neumann's law if nothing drives the foam and
/// no T2 happens nearby. The image has one channel. It is 0 around a patch, and everywhere if no
/// time passes until the next frame. Throws std::invalid_argument if there is no next frame.
NumberPixels draw_growth(FrameLayers& layers, const GrowthOptions& options);

}  // namespace foam::texgen
