#pragma once

#include "core/foam/foam.h"

namespace foam {

/// The position of every junction.
using Positions = Indexed<JunctionId, Vec2>;

/// Moves the whole foam back by the median motion, along x and along y, of the junctions that it
/// still has. Equilibrium leaves open where the foam is; the median keeps everything at rest that
/// is far from a change. Precondition: `before` holds the positions of the same network, T1s and
/// T2s since then aside.
void undo_drift(Foam& foam, const Positions& before);

}  // namespace foam
