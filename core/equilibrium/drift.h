// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"

namespace foam {

/// The position of every junction.
using Positions = Indexed<JunctionId, Vec2>;

/// Undoes the drift of the foam: translates all of it by minus the median motion of its live
/// junctions since `before`. The median is taken along x and along y separately. Equilibrium does
/// not determine the position of the foam as a whole; with the median, everything that is far from
/// a change stays at rest. Precondition: `before` holds the positions of the same network, except
/// for T1s and T2s since then.
void undo_drift(Foam& foam, const Positions& before);

}  // namespace foam
