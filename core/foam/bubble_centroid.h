// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/frame.h"

namespace foam {

/// Returns the center of area of a bubble within its arcs. On a torus, the point is near the tail of
/// the bubble's first half-edge, so it may be outside of the fundamental cell. Returns this tail if
/// the bubble has no area. Precondition: the bubble is not the ghost.
Vec2 bubble_centroid(const Frame& frame, BubbleId bubble);

}  // namespace foam
