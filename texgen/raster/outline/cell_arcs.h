// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/frame.h"
#include "texgen/raster/arcs/monotone_arc.h"

namespace foam::texgen {

/// Returns the arcs that bound the visible parts of every bubble of a frame. They are divided into
/// pieces that are monotone in x and in y. `film_width` is in pixels. A film covers all points
/// whose distance from its arc is less than half the width.
///
/// If the width is 0, bubbles meet at their films. On a torus, the result then contains each film
/// once, with a bubble on either side. In a patch, it contains each film twice, once per bubble. If
/// the width is positive, each visible part of a bubble other than the ghost bubble is bounded by
/// one closed chain of arcs. There are films on the other side of this chain.
///
/// In a patch, arcs also bound the ghost bubble and the lone bubbles. In ArcSides, the indices of
/// lone bubbles follow the index of the ghost bubble. Some arcs that do not affect any pixel are
/// left out.
///
/// Apart from CellArcs::grid, the result depends neither on threads nor on the shift of the grid.
/// Throws std::invalid_argument in these cases:
/// - The film width is negative or not finite.
/// - The grid is too large or empty, or does not fit the domain (pixels_per_unit).
CellArcs cell_arcs(const Frame& frame, const RasterGrid& grid, double film_width, int threads);

/// Implements cell_arcs for a frame in the plane. Precondition: the width is finite and not
/// negative.
CellArcs patch_arcs(const Frame& frame, const RasterGrid& grid, double film_width, int threads);

}  // namespace foam::texgen
