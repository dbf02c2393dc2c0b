#pragma once

#include "core/foam/frame.h"

namespace foam::texgen {

/// Returns the motion of every junction until the next frame, in foam units. A junction is
/// identified by the bubbles that meet there, in their order; among several, by the nearest. One
/// that is lost in between, by T1 or T2, moves like the mean of its neighbors.
Indexed<JunctionId, Vec2> junction_motion(const Frame& frame, const Frame& next);

}  // namespace foam::texgen
