// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/frame.h"
#include "texgen/raster/coords/raster_grid.h"
#include "texgen/raster/distance/distance_field.h"

namespace foam::texgen {

/// Returns the distance field of a frame on the pixels of a grid: the ids of the bubbles, and the
/// images that `needs` selects.
///
/// The result has the same bits for any number of threads. If the grid is shifted, the images are
/// shifted cyclically (RasterGrid). Throws std::invalid_argument if the grid is too large or empty,
/// or if it does not fit the domain (pixels_per_unit).
DistanceField distance_field(const Frame& frame,
                             const RasterGrid& grid,
                             DistanceNeeds needs,
                             int threads);

/// Computes the same distance field as distance_field, but writes it to `field`, whose memory is
/// reused if its images have the size of the grid. Throws the exceptions of distance_field. If an
/// exception is thrown because of the grid, `field` is unchanged.
void write_distance_field(const Frame& frame,
                          const RasterGrid& grid,
                          DistanceNeeds needs,
                          int threads,
                          DistanceField& field);

}  // namespace foam::texgen
