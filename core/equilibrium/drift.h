#pragma once

#include "core/foam/foam.h"

namespace foam {

/// Where all junctions are.
using Positions = Indexed<JunctionId, Vec2>;

/// Moves the foam back as a whole by the median motion, along x and along y, of the junctions that
/// it still has: nothing else says where it is, and so what happens in one place leaves the rest at
/// rest. Precondition: `before` are positions of the same network, T1 and T2 since then aside.
void undo_drift(Foam& foam, const Positions& before);

}  // namespace foam
