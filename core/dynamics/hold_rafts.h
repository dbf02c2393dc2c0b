#pragma once

#include "core/foam/foam.h"

#include <map>

namespace foam {

/// Returns the center of each bubble of a patch: the mean of all points of its films.
std::map<BubbleIdentity, Vec2> bubble_centres(const Foam& patch);

/// Moves and turns every raft of a patch as a whole to where its bubbles were before, by least
/// squares. Equilibrium determines neither position nor rotation, and a solver changes both; but a
/// raft on which nothing pulls does not move. A bubble that has just come loose returns to its
/// position.
void hold_rafts(Foam& patch, const std::map<BubbleIdentity, Vec2>& before);

}  // namespace foam
