// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/frame.h"

namespace foam::texgen {

/// Returns the motion of every junction until the next frame, in foam units. A junction is
/// identified by the bubbles that meet there and their order; if several junctions of the next
/// frame have these bubbles, the nearest one counts. A junction that a T1 or T2 removes in between
/// moves like the mean of its neighbors; the motion is 0 if no junction is left to follow.
Indexed<JunctionId, Vec2> junction_motion(const Frame& frame, const Frame& next);

}  // namespace foam::texgen
