// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"

namespace foam::texgen {

/// Two sequences of numbers, indexed by identity. The pairs of numbers with equal index are spread
/// evenly in the unit square: the steps are 1/p and 1/p², where p is the root of x³ = x + 1 (the R2
/// sequence of M. Roberts, 2018).
enum class IdentityStream { First, Second };

/// Returns a number in [0, 1) that a bubble keeps for life. Consecutive identities have distant
/// numbers, and all numbers together are spread evenly (low discrepancy), because they are the
/// fractional parts of multiples of an irrational step.
double identity_number(BubbleIdentity identity, IdentityStream stream);

}  // namespace foam::texgen
