#pragma once

#include "texgen/raster/distance.h"

namespace foam::texgen {

/// Writes the field of a frame on a torus into images that are there; as write_distance_field.
void write_torus_field(const Frame& frame,
                       const RasterGrid& grid,
                       DistanceNeeds needs,
                       int threads,
                       DistanceField& field);

}  // namespace foam::texgen
