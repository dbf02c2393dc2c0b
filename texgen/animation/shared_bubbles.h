// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/frame.h"

#include <optional>
#include <vector>

namespace foam::texgen {

/// Returns, for every bubble of `from` in the order of Frame::bubbles, the displacement to the
/// bubble of the same identity in `to`, in foam units. The displacement is measured between the
/// means of the junctions of both bubbles. It is nullopt if `to` has no such bubble, or if the
/// displacement is longer than the diameter of a mean bubble. Precondition: both foams are on the
/// same torus.
std::vector<std::optional<Vec2>> displacements_of_shared(const Frame& from, const Frame& to);

/// Returns the frame `from` with its bubbles moved toward the bubbles of the same identity in `to`,
/// by a fraction of the displacement (displacements_of_shared). A bubble that has no displacement
/// moves with its neighbors. If it is more than two bubbles away from all bubbles that have a
/// displacement, its displacement counts as 0. A junction moves by the mean displacement of its
/// three bubbles. If two frames are moved toward each other by fractions that add up to 1, the
/// bubbles that have a displacement are then at about the same positions in both.
Frame moved_toward(const Frame& from, const Frame& to, double fraction);

}  // namespace foam::texgen
