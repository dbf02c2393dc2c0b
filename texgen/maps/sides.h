#pragma once

#include "texgen/maps/map_image.h"

namespace foam::texgen {

class FrameLayers;

/// How many films go around the bubble at the middle of every pixel: exact, never mixed. 0 in lone
/// bubbles, whose film has no junction, and around a patch.
IdPixels draw_sides(FrameLayers& layers);

}  // namespace foam::texgen
