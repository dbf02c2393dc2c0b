// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/frame.h"
#include "texgen/maps/arc_distance.h"

#include <functional>
#include <vector>

namespace foam::texgen {

/// Returns the arcs of the films for which is_chosen(film) is true. Also returns the circles of all
/// lone bubbles, each as two arcs. Throws std::invalid_argument in the same cases as
/// pixels_per_unit (raster_grid.h).
std::vector<PlacedArc> arcs_of_films(const Frame& frame,
                                     const RasterGrid& grid,
                                     int threads,
                                     const std::function<bool(FilmId)>& is_chosen);

}  // namespace foam::texgen
