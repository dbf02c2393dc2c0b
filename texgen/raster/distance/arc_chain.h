#pragma once

#include "core/geometry/film_arc.h"

#include <vector>

namespace foam::texgen {

/// Appends the inner points of a chain of straight edges that approximates an arc from a tail on;
/// pixels. The ends of the arc are the caller's. An arc that is nearly straight has no inner
/// points, nor has one of no length.
///
/// The points are a little outside the arc, so that chain and arc enclose the same area. The area
/// between them is below 0.0015 pixels in any pixel.
void append_inner_points(const FilmArc& arc, const Vec2& tail, std::vector<Vec2>& points);

}  // namespace foam::texgen
