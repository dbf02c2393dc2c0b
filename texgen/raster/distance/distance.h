#pragma once

#include "core/foam/frame.h"
#include "texgen/raster/coords/raster_grid.h"
#include "texgen/raster/distance/distance_field.h"

namespace foam::texgen {

/// Returns the distance field of a frame. Each pixel is measured from the arcs of its own bubble:
/// the shortest path to a film crosses no other film.
///
/// The result has the same bits for any number of threads, and a shift of the grid gives the exact
/// cyclic shift of the images. Throws std::invalid_argument as pixels_per_unit does.
DistanceField distance_field(const Frame& frame,
                             const RasterGrid& grid,
                             DistanceNeeds needs,
                             int threads);

/// Writes the distance field of a frame into an existing field and reuses the field's memory.
void write_distance_field(const Frame& frame,
                          const RasterGrid& grid,
                          DistanceNeeds needs,
                          int threads,
                          DistanceField& field);

}  // namespace foam::texgen
