#pragma once

#include "core/foam/frame.h"
#include "texgen/raster/coords/raster_grid.h"
#include "texgen/raster/distance/region.h"

#include <vector>

namespace foam::texgen {

/// Returns the regions of a frame in the plane that a grid with a view may show: first what
/// surrounds the foam, then bubbles and lone bubbles in their order. Their boxes are within the
/// image.
std::vector<Region> patch_regions(const Frame& frame, const RasterGrid& grid, int threads);

}  // namespace foam::texgen
