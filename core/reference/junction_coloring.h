// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/network/network.h"

#include <vector>

namespace foam {

/// Colors the live junctions greedily, in the order of their ids, so that no two junctions of a
/// color share a bubble. Junctions of a color may share the ghost, since no block (E5) changes
/// the ghost's pressure. Returns the junctions of each color, in the order of their ids. The number
/// of colors is at least the largest number of junctions of a bubble, the ghost excluded.
std::vector<std::vector<JunctionId>> color_junctions(const Network& network);

}  // namespace foam
