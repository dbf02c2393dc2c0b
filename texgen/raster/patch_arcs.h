#pragma once

#include "texgen/raster/cell_arcs.h"

namespace foam::texgen {

/// As cell_arcs, of a frame in the plane.
CellArcs arcs_of_patch(const Frame& frame, const RasterGrid& grid, double film_width, int threads);

}  // namespace foam::texgen
