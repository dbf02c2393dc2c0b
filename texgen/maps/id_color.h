#pragma once

#include "core/foam/foam.h"
#include "texgen/image/color.h"
#include "texgen/maps/map_image.h"

namespace foam::texgen {

class FrameLayers;

/// The colour of a bubble, its own for life. Identities that follow each other have hues that lie
/// far apart, and different lightnesses: a sequence of low discrepancy in OKLCh (Ottosson 2020),
/// all of it within sRGB.
LinearRgb identity_color(BubbleIdentity identity);

/// Every bubble in its identity_color, without films. Transparent around a patch.
ColorPixels draw_id_color(FrameLayers& layers);

}  // namespace foam::texgen
