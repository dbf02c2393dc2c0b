#pragma once

#include "core/foam/foam.h"

namespace foam::texgen {

/// A number in [0, 1) that a bubble has for life. Those of consecutive identities lie far apart and
/// all together evenly: the fractional parts of multiples of an irrational step. Streams are
/// independent of each other: multiples of inverse powers of the root of x³ = x + 1 are spread
/// evenly in the plane, too.
enum class IdentityStream { First, Second };
double identity_number(BubbleIdentity identity, IdentityStream stream);

}  // namespace foam::texgen
