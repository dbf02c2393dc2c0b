// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/network/network.h"

namespace foam {

/// Adds the ghost to a network that lacks it. Every half-edge without a bubble on its left becomes
/// a half-edge of the ghost; its tail and its successor are set. Preconditions:
/// - first() of each bubble is set;
/// - each half-edge of a bubble has its left bubble, its tail and its successor;
/// - each film has a bubble on at least one side.
void add_ghost_boundary(Network& network);

}  // namespace foam
