#pragma once

#include "texgen/maps/albedo.h"
#include "texgen/maps/map_image.h"

namespace foam::texgen {

class FrameLayers;

/// The mask of films as wide as those of albedo: of every pixel the part that they cover. One
/// channel, 0 to 1; 0 around a patch.
NumberPixels draw_film(FrameLayers& layers, const AlbedoOptions& options);

}  // namespace foam::texgen
