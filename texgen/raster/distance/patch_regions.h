// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/frame.h"
#include "core/geometry/film_arc.h"
#include "texgen/raster/coords/raster_grid.h"
#include "texgen/raster/distance/region.h"

#include <vector>

namespace foam::texgen {

/// Returns the regions of a frame of a patch. The first region is the surroundings of the foam. It
/// is followed by the bubbles and the lone bubbles that may be visible in the image, in the order
/// of their indices. The boxes of the regions are clipped to the image. Throws
/// std::invalid_argument if the grid is too large or empty or has no view (pixels_per_unit).
/// Precondition: the foam is a patch.
std::vector<Region> patch_regions(const Frame& frame, const RasterGrid& grid, int threads);

/// Appends the points between the two ends of a chain of straight edges that approximates an arc.
/// The ends themselves are not appended. `tail` is the start of the arc. Positions and the chord of
/// the arc are in pixels. An arc that is nearly straight or has no length has no such points.
///
/// The points are slightly beyond the arc, on its convex side, so that the chain encloses nearly
/// the same area as the arc. README.md gives a bound of the difference.
void append_chain_points(const FilmArc& arc, const Vec2& tail, std::vector<Vec2>& points);

}  // namespace foam::texgen
