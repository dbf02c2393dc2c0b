// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"
#include "core/foam/outline.h"

#include <vector>

namespace foam {

/// Returns the positions of the junctions of a bubble, counter-clockwise from the tail of its first
/// half-edge. Each position is the previous position plus the chord of the film between them. On a
/// torus, positions may therefore be outside of the fundamental cell.
std::vector<Vec2> corners_of(const Foam& foam, BubbleId bubble);

/// Returns the mean of corners_of(foam, bubble). On a torus, this point may belong to any lattice
/// copy of the bubble.
Vec2 mean_corner(const Foam& foam, BubbleId bubble);

/// Returns the bounding box of the stored positions of all junctions. If there is no junction, its
/// low corner is at plus infinity and its high corner at minus infinity.
Box box_around_junctions(const Foam& foam);

}  // namespace foam
