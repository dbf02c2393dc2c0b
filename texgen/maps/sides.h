// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/maps/map.h"

namespace foam::texgen {

inline constexpr MapTraits kSidesMap = {
    .name = "sides",
    .meaning = "number of films around a bubble, not averaged",
    .unit = "films; PNG: the number itself",
    .channels = "Y",
    .kind = MapKind::Id,
};

/// Draws the number of films around the bubble at the center of every pixel. No pixel has
/// a mean of two numbers. The number is 0 in lone bubbles, whose film has no junction, and around a
/// patch.
IdPixels draw_sides(FrameLayers& layers);

}  // namespace foam::texgen
