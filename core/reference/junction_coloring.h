// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/network/network.h"

#include <vector>

namespace foam {

/// Colors the live junctions greedily, in the order of their ids, so that no two junctions of a
/// color share a bubble. The ghost does not count as a bubble, since no block changes it. Returns
/// the junctions of each color, in increasing order. There are at least as many colors as the
/// largest bubble has junctions.
std::vector<std::vector<JunctionId>> color_junctions(const Network& network);

}  // namespace foam
