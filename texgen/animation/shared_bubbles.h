// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/frame.h"

#include <optional>
#include <vector>

namespace foam::texgen {

/// Returns the displacement of every bubble of `from` to the bubble of the same identity in `to`;
/// nothing if `to` has no such bubble, or if it is more than a mean bubble diameter away. The
/// displacement is that of the mean of the junctions. Precondition: both foams are on the same
/// torus.
std::vector<std::optional<Vec2>> displacements_of_shared(const Frame& from, const Frame& to);

/// Returns the frame `from` with its bubbles moved to the same bubbles in `to`, by a fraction of
/// the way. Bubbles that are not shared move with their neighbors. If two foams are moved towards
/// each other by fractions that add up to 1, shared bubbles are in the same places.
Frame moved_towards(const Frame& from, const Frame& to, double fraction);

}  // namespace foam::texgen
