// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/frame.h"
#include "texgen/raster/arcs/monotone_arc.h"

namespace foam::texgen {

/// Returns the arcs that bound the visible part of every bubble of a frame. A film covers all
/// points within half of its width; `film_width` is the whole width in pixels.
///
/// If the width is 0, each film appears once, between its two bubbles. Otherwise each visible part
/// of a bubble is bounded by one closed chain of arcs. Most bubbles have one visible part; a bubble
/// that is covered by its films has none. In a patch, arcs also bound the ghost bubble and the lone
/// bubbles; the indices of lone bubbles follow the index of the ghost bubble. Arcs of a patch that
/// do not affect any pixel are left out.
///
/// Apart from CellArcs::grid, the result depends neither on the number of threads nor on the shift
/// of the grid. Throws
/// std::invalid_argument if the width is negative or not finite, or if pixels_per_unit throws it.
CellArcs cell_arcs(const Frame& frame, const RasterGrid& grid, double film_width, int threads);

/// Implements cell_arcs for a frame in the plane.
CellArcs patch_arcs(const Frame& frame, const RasterGrid& grid, double film_width, int threads);

}  // namespace foam::texgen
