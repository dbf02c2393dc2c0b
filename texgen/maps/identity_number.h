#pragma once

#include "core/foam/foam.h"

namespace foam::texgen {

/// Returns a number in [0, 1) that a bubble has for life. Consecutive identities have distant
/// numbers, and all numbers together are spread evenly: they are the fractional parts of multiples
/// of an irrational step. The two streams together are spread evenly in the plane, because the
/// steps are inverse powers of the root of x³ = x + 1.
enum class IdentityStream { First, Second };
double identity_number(BubbleIdentity identity, IdentityStream stream);

}  // namespace foam::texgen
