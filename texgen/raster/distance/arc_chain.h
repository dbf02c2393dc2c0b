// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/geometry/film_arc.h"

#include <vector>

namespace foam::texgen {

/// Appends the inner points of a chain of straight edges that approximates an arc. `tail` is where
/// the arc begins; positions are in pixels. The ends of the arc are not appended. An arc that is
/// nearly straight or has no length has no inner points.
///
/// The points are slightly outside the arc, so that chain and arc enclose the same area. The area
/// between them is below 0.0015 square pixels in any pixel.
void append_inner_points(const FilmArc& arc, const Vec2& tail, std::vector<Vec2>& points);

}  // namespace foam::texgen
