// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/maps/per_bubble.h"

namespace foam::texgen {

/// Replaces the value of every bubble by the mean of the values of the bubble and of its neighbors,
/// `rounds` times. In the mean, the bubble itself weighs as much as all its neighbors together, and
/// the weight of a neighbor is the length of the films between both. The ghost of a patch and lone
/// bubbles are no neighbors. Each round spreads values by about one bubble.
void average_with_neighbors(const Frame& frame, int rounds, PerBubble<double>& values);

}  // namespace foam::texgen
