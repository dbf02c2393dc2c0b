#pragma once

#include "texgen/maps/albedo.h"
#include "texgen/maps/map_image.h"

namespace foam::texgen {

class FrameLayers;

/// Of every pixel the part that bubbles and films cover, the outer films of a patch to half their
/// width outwards: what albedo has as its alpha. One channel, 0 to 1; 1 everywhere on a torus.
NumberPixels draw_opacity(FrameLayers& layers, const AlbedoOptions& options);

}  // namespace foam::texgen
