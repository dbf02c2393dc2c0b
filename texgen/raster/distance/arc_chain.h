// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/geometry/film_arc.h"

#include <vector>

namespace foam::texgen {

/// Appends the inner points of a chain of straight edges that approximates an arc. `tail` is the
/// start of the arc. Positions and the chord of the arc are in pixels. The ends of the arc are not
/// appended. An arc that is nearly straight or has no length has no inner points.
///
/// The points are slightly beyond the arc, on its convex side, so that the chain encloses nearly
/// the same area as the arc. In any pixel, the areas that the chain and the arc enclose differ by
/// less than 0.0015 square pixels.
void append_chain_points(const FilmArc& arc, const Vec2& tail, std::vector<Vec2>& points);

}  // namespace foam::texgen
