// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/frame.h"
#include "texgen/raster/arcs/monotone_arc.h"

namespace foam::texgen {

/// Returns the arcs that bound what shows of every bubble of a frame when each film covers all
/// points within half its width; `film_width` is the whole width in pixels.
///
/// Without a width, each film appears once, between its two bubbles. With a width, a bubble is
/// bounded by one closed chain of arcs for each part that its films leave free: mostly one, none if
/// it is all film. In a patch the ghost is bounded too, and lone bubbles have the indices that
/// follow the ghost's, in their order; arcs that no pixel shows are left out.
///
/// The result is the same for any number of threads, and for any shift of the grid except for
/// `grid` itself. Throws std::invalid_argument as pixels_per_unit does, or if the width is negative
/// or not finite.
CellArcs cell_arcs(const Frame& frame, const RasterGrid& grid, double film_width, int threads);

/// Implements cell_arcs for a frame in the plane.
CellArcs patch_arcs(const Frame& frame, const RasterGrid& grid, double film_width, int threads);

}  // namespace foam::texgen
