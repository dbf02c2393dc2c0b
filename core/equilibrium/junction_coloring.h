#pragma once

#include "core/network/network.h"

#include <vector>

namespace foam {

/// The live junctions in colours: no two of a colour share a bubble, the ghost apart, which no
/// block changes. Each takes the first colour
/// that is free, in the order of ids; ids increase within a colour. There are at least as many
/// colours as the largest bubble has junctions.
std::vector<std::vector<JunctionId>> color_junctions(const Network& network);

}  // namespace foam
