// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/network/network.h"

namespace foam {

/// Adds the ghost to a network that lacks it. Every half-edge without a bubble on its left becomes
/// a half-edge of the ghost; its tail and its successor are set. Precondition: the half-edges
/// around the bubbles are linked, and each film has a bubble on at least one side.
void add_outside(Network& network);

}  // namespace foam
