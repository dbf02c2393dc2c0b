#pragma once

#include "core/foam/frame.h"
#include "texgen/raster/pixel_arc.h"

#include <vector>

namespace foam::texgen {

/// The arcs of all films, each as its forward side, in pixels of a scale (pixels per foam unit).
std::vector<PixelArc> film_shapes(const Frame& frame, double scale, int threads);

}  // namespace foam::texgen
