// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"

namespace foam::texgen {

/// Two sequences of numbers, indexed by the identity of a bubble. The number of the identity n is
/// the fractional part of (n + 1) s. The step s is 1/p in the first sequence and 1/p² in the
/// second, where p is the real root of x³ = x + 1. These are the steps of the R2 sequence of M.
/// Roberts (2018). With them, the points (first number, second number) of all identities are spread
/// evenly in the unit square.
enum class IdentityStream { First, Second };

/// Returns a number in [0, 1) that a bubble keeps for life. Consecutive identities have distant
/// numbers, and all numbers together are spread evenly (low discrepancy).
double identity_number(BubbleIdentity identity, IdentityStream stream);

}  // namespace foam::texgen
