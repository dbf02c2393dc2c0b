// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/frame.h"
#include "texgen/raster/coords/raster_grid.h"
#include "texgen/raster/distance/region.h"

#include <vector>

namespace foam::texgen {

/// Returns the regions of a frame in the plane that may be visible on a grid with a view: first the
/// surroundings of the foam, then the bubbles, then the lone bubbles, each in the order of their
/// indices. The boxes of the regions are clipped to the image.
std::vector<Region> patch_regions(const Frame& frame, const RasterGrid& grid, int threads);

}  // namespace foam::texgen
