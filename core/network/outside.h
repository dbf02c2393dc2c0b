// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/network/network.h"

namespace foam {

/// Adds the ghost to a network that lacks it. Every half-edge without a bubble on its left becomes
/// one of the ghost's, and gets its tail and its successor. Precondition: the half-edges around the
/// bubbles are linked, and each film has a bubble on at least one side.
void add_outside(Network& network);

}  // namespace foam
