#pragma once

#include "core/network/network.h"

#include <vector>

namespace foam {

/// Colors the live junctions greedily, in the order of their ids, so that no two of a color share a
/// bubble; the ghost, which no block changes, does not count. Returns the junctions by color, in
/// increasing order within a color. There are at least as many colors as the largest bubble has
/// junctions.
std::vector<std::vector<JunctionId>> color_junctions(const Network& network);

}  // namespace foam
