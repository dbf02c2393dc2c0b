#pragma once

#include "core/network/network.h"

namespace foam {

/// Adds the ghost to a network of bubbles that lacks it: it takes every half-edge that has no
/// bubble on its left, its tail and its successor not set. Precondition: the half-edges around the
/// bubbles are linked, and each film has a bubble on one side at least.
void add_outside(Network& network);

}  // namespace foam
