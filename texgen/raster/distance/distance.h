// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/frame.h"
#include "texgen/raster/coords/raster_grid.h"
#include "texgen/raster/distance/distance_field.h"

namespace foam::texgen {

/// Returns the distance field of a frame. The distance of each pixel is measured from the arcs of
/// its own bubble only, because the shortest path to a film crosses no other film.
///
/// The result is the same to the bit for any number of threads. A shift of the grid shifts the
/// images cyclically, to the bit. Throws std::invalid_argument as pixels_per_unit does.
DistanceField distance_field(const Frame& frame,
                             const RasterGrid& grid,
                             DistanceNeeds needs,
                             int threads);

/// Writes the distance field of a frame into an existing field, whose memory it reuses. The result
/// and the exceptions are the same as for distance_field.
void write_distance_field(const Frame& frame,
                          const RasterGrid& grid,
                          DistanceNeeds needs,
                          int threads,
                          DistanceField& field);

}  // namespace foam::texgen
