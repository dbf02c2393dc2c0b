// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/equilibrium/equilibrate.h"
#include "core/foam/foam.h"
#include "core/foam/measure.h"

#include <optional>
#include <string>

namespace foam::stress {

/// Checks a foam that should be in equilibrium. Returns a description of the first fault, or
/// nullopt if there is none. Faults are:
/// - an invalid network, a number that is not finite, or a target area that is not positive
/// - on a torus, target areas whose sum differs from its area by more than 1e-9 of this area
/// - a relative area error or an angle error (radians) above the tolerance
/// - a film whose half angle is clamped to the limit
/// - in a patch, an outer film that violates Laplace-Young's law by more than the tolerance, or an
///   energy that differs from 2 sum p A by more than the tolerance (relative)
std::optional<std::string> find_unsoundness(const Foam& foam, double tolerance);

/// Returns the status in words.
const char* name_of(EquilibriumStatus status);

}  // namespace foam::stress
