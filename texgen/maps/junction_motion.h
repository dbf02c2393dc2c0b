// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/frame.h"

namespace foam::texgen {

/// Returns the motion of every junction until the next frame, in foam units. A junction is
/// identified by the bubbles that meet there and their cyclic order. If several junctions of the
/// next frame have the same bubbles in the same order, the nearest one is used. A junction whose
/// bubbles do not meet in the next frame, for example after a T1 or T2, gets the mean motion of its
/// neighbors. Its motion is 0 if no path of films connects it to a junction that has been found in
/// the next frame.
Indexed<JunctionId, Vec2> junction_motion(const Frame& frame, const Frame& next);

}  // namespace foam::texgen
