#pragma once

#include "core/foam/foam.h"

#include <map>

namespace foam {

/// Where the bubbles of a patch are: of each the mean of all points of its films.
std::map<BubbleIdentity, Vec2> bubble_centres(const Foam& patch);

/// Moves and turns every raft of a patch as a whole to where its bubbles were before, as nearly as
/// the mean square says. Equilibrium leaves both open, and a solver leaves them anywhere; but a
/// raft on which nothing pulls does not move. A bubble that has just come loose goes back to its
/// place.
void hold_rafts(Foam& patch, const std::map<BubbleIdentity, Vec2>& before);

}  // namespace foam
