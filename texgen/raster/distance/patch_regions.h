// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/frame.h"
#include "core/geometry/film_arc.h"
#include "texgen/raster/coords/raster_grid.h"
#include "texgen/raster/distance/region.h"

#include <vector>

namespace foam::texgen {

/// Returns the regions of a frame in the plane that may be visible on a grid with a view: first the
/// surroundings of the foam, then the bubbles, then the lone bubbles, each in the order of their
/// indices. The boxes of the regions are clipped to the image. Throws std::invalid_argument if the
/// grid is too large or empty, or if it does not fit the domain (pixels_per_unit).
std::vector<Region> patch_regions(const Frame& frame, const RasterGrid& grid, int threads);

/// Appends the inner points of a chain of straight edges that approximates an arc. `tail` is the
/// start of the arc. Positions and the chord of the arc are in pixels. The ends of the arc are not
/// appended. An arc that is nearly straight or has no length has no inner points.
///
/// The points are slightly beyond the arc, on its convex side, so that the chain encloses nearly
/// the same area as the arc. README.md gives a bound of the difference.
void append_chain_points(const FilmArc& arc, const Vec2& tail, std::vector<Vec2>& points);

}  // namespace foam::texgen
