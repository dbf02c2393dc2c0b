// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/dynamics/solver.h"
#include "core/foam/foam.h"

#include <map>

namespace foam {

/// Returns the center of each bubble of a patch: the mean of the points of its films, weighted by
/// length. The center of a lone bubble is the center of its circle.
std::map<BubbleIdentity, Vec2> bubble_centers(const Foam& patch);

/// Moves and rotates every raft of a patch as a rigid body so that the centers of its bubbles fit
/// `earlier_centers` by least squares. Equilibrium determines neither the position nor the rotation
/// of a raft, so that a solver may change both, although no force moves the raft. Bubbles without
/// an earlier center are ignored. A lone bubble returns to its earlier center, if it has one.
void restore_rafts(Foam& patch, const std::map<BubbleIdentity, Vec2>& earlier_centers);

/// Brings a foam to equilibrium (equilibrate_with). If it converges, the rafts of a patch return to
/// their earlier positions and rotations (restore_rafts). Removes the dead slots of a patch.
EquilibriumSummary equilibrate_keeping_rafts(Solver solver,
                                             Foam& foam,
                                             const EquilibriumOptions& options);

}  // namespace foam
