// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"

namespace foam::texgen {

/// Two sequences of numbers for identities. The pairs of both are spread evenly in the unit square,
/// because the steps of the sequences are inverse powers of the root of x³ = x + 1.
enum class IdentityStream { First, Second };

/// Returns a number in [0, 1) that a bubble keeps for life. Consecutive identities have distant
/// numbers, and all numbers together are spread evenly (low discrepancy): they are the fractional
/// parts of multiples of an irrational step.
double identity_number(BubbleIdentity identity, IdentityStream stream);

}  // namespace foam::texgen
