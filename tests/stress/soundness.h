// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/equilibrium/equilibrate.h"
#include "core/foam/foam.h"
#include "core/foam/measure.h"

#include <optional>
#include <string>

namespace foam::stress {

/// What is wrong with a foam that should be in equilibrium, in words, or nothing: a fault of the
/// network, a number that is not finite, a target area that is not positive, targets that do not
/// add up to the torus (to 1e-9 of it), an area (relative) or angle (radians) error above the
/// tolerance, a film held at the largest half angle; of a patch also an outer film that misses
/// Laplace-Young's law, and an energy that is not 2 sum p A, by more than the tolerance.
std::optional<std::string> find_unsoundness(const Foam& foam, double tolerance);

/// A status in words.
const char* name_of(EquilibriumStatus status);

}  // namespace foam::stress
