#pragma once

#include "core/foam/frame.h"

namespace foam::texgen {

/// How far every junction of a frame moves to the next frame, in foam units. A junction is known by
/// the bubbles that meet there, in their order; of several such, the nearest. One that is lost in
/// between, by T1 or T2, moves as those it is joined to do, in the mean.
Indexed<JunctionId, Vec2> junction_motion(const Frame& frame, const Frame& next);

}  // namespace foam::texgen
