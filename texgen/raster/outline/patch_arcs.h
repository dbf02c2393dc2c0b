#pragma once

#include "core/foam/frame.h"
#include "texgen/raster/arcs/monotone_arc.h"

namespace foam::texgen {

/// Implements cell_arcs for a frame in the plane.
CellArcs patch_arcs(const Frame& frame, const RasterGrid& grid, double film_width, int threads);

}  // namespace foam::texgen
