// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/maps/per_bubble.h"

namespace foam::texgen {

/// Replaces the value of every bubble by the mean of the values of the bubble and of its neighbors,
/// `rounds` times. In the mean, the bubble itself weighs as much as all its neighbors together. The
/// weight of a neighbor is the length of the films between the two bubbles. The ghost of a patch
/// does not count as a neighbor; lone bubbles have no neighbors and keep their values. Each round
/// spreads values by about one bubble.
void average_with_neighbors(const Frame& frame, int rounds, PerBubble<double>& values);

}  // namespace foam::texgen
