#pragma once

#include "texgen/maps/map_image.h"

namespace foam::texgen {

class FrameLayers;

/// The identity of the bubble at the middle of every pixel, plus 1: exact, never mixed, the same
/// for the bubble's whole life. 0 around a patch. The codes of a PNG are its lowest 16 bits.
IdPixels draw_id(FrameLayers& layers);

}  // namespace foam::texgen
