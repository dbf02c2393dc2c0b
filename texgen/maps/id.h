// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/maps/map.h"

namespace foam::texgen {

inline constexpr MapTraits kIdMap = {
    .name = "id",
    .meaning = "permanent id of a bubble plus 1, not averaged; 0 around a patch",
    .unit = "PNG: the lowest 16 bits of the id",
    .channels = "Y",
    .kind = MapKind::Id,
    .png_bits = 16};

/// Draws the identity of the bubble at the center of every pixel, plus 1; pixels around a patch are
/// 0. Identities are never mixed. A bubble keeps its identity for its whole life. A PNG stores the
/// lowest 16 bits.
IdPixels draw_id(FrameLayers& layers);

}  // namespace foam::texgen
