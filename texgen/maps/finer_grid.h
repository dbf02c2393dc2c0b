// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/image.h"
#include "texgen/raster/coords/raster_grid.h"

#include <algorithm>

namespace foam::texgen {

/// Returns the number of samples per pixel in each direction for a map that is drawn on a finer
/// grid: `max_samples`, or fewer if a side of the finer grid would exceed kMaxGridSide.
inline int samples_for(const RasterGrid& grid, int max_samples) {
    return std::clamp(kMaxGridSide / std::max(grid.width, grid.height), 1, max_samples);
}

/// Returns a grid with `samples` times as many pixels in each direction, which shows the same tile
/// or view.
inline RasterGrid finer(RasterGrid grid, int samples) {
    grid.width *= samples;
    grid.height *= samples;
    grid.shift_x *= samples;
    grid.shift_y *= samples;
    if (grid.view) {
        grid.view->pixels_per_unit *= samples;
    }
    return grid;
}

}  // namespace foam::texgen
