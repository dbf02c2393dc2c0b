// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"

namespace foam {

/// The position of every junction.
using Positions = Indexed<JunctionId, Vec2>;

/// Undoes the drift of the foam: translates all junctions by minus the median of their motions
/// since `earlier`. Lone bubbles are not moved. The median is taken along x and along y separately.
/// Equilibrium does not determine the position of the foam as a whole; with the median, everything
/// that is far from a change stays at rest. Precondition: `earlier` contains the earlier positions
/// of the junctions of the same network, which has since changed by T1s and T2s only.
void undo_drift(Foam& foam, const Positions& earlier);

}  // namespace foam
