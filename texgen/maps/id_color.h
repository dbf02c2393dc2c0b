// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"
#include "texgen/image/color.h"
#include "texgen/maps/map.h"

namespace foam::texgen {

inline constexpr MapTraits kIdColorMap = {
    .name = "id_color",
    .meaning = "a distinct color for every bubble, constant for its life",
    .unit = "light",
    .channels = "R G B",
    .kind = MapKind::Color,
};

/// Returns the color that a bubble has for life. Consecutive identities have very different
/// hues, and different lightnesses: hue and lightness in OKLCh (Ottosson 2020) follow a
/// low-discrepancy sequence (identity_number), and the chroma is constant. All colors are within
/// sRGB.
LinearRgb identity_color(BubbleIdentity identity);

/// Draws every bubble in its identity_color, without films. The surroundings of a patch are
/// transparent.
ColorPixels draw_id_color(FrameLayers& layers);

}  // namespace foam::texgen
