// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"

#include <vector>

namespace foam {

/// Returns the positions of the junctions of a bubble, counter-clockwise from the tail of its first
/// half-edge. On a torus, each position is at the lattice copy that the film from the position
/// before it reaches, so that positions may be outside of the fundamental cell.
std::vector<Vec2> corners_of(const Foam& foam, BubbleId bubble);

/// Returns the mean of the junctions of a bubble. On a torus it may belong to any lattice copy of
/// the bubble.
Vec2 mean_corner(const Foam& foam, BubbleId bubble);

}  // namespace foam
