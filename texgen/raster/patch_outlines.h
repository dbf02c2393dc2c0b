#pragma once

#include "texgen/raster/outlines.h"

namespace foam::texgen {

/// outline_cells of a frame in the plane, for a grid with a view of it.
CellOutlines outline_patch(const Frame& frame, const RasterGrid& grid, int threads);

}  // namespace foam::texgen
