#pragma once

#include "texgen/maps/map.h"

namespace foam::texgen {

inline constexpr MapTraits kIdMap = {
    .name = "id",
    .meaning = "number of a bubble for life plus 1, exact; 0 around a patch",
    .unit = "PNG: lowest 16 bits",
    .channels = "Y",
    .png_bits = 16};

/// Draws the identity of the bubble at the center of every pixel, plus 1. It is never mixed, and
/// stays the same for the bubble's whole life. 0 around a patch. The codes of a PNG are its lowest
/// 16 bits.
IdPixels draw_id(FrameLayers& layers);

}  // namespace foam::texgen
