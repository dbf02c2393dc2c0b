// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/raster/arcs/pixel_arc.h"

namespace foam::texgen {

/// Clips a rising monotone piece of an arc to a box with the corners `low` and `high`. Returns the
/// pieces that replace it, from the lowest to the highest. The part to the left of the box is
/// replaced by the left border of the box at the same heights. It cannot be dropped, because an arc
/// affects all pixels on its right. The parts above, below and to the right of the box are dropped.
boost::container::static_vector<MonotonePiece, 2> clipped(const MonotonePiece& piece,
                                                          const Vec2& low,
                                                          const Vec2& high);

}  // namespace foam::texgen
