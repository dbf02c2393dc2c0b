// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/vector/chain.h"

#include <vector>

namespace foam::texgen {

/// Closes open chains along the border of the tile [0, width] x [0, height]. The chains are parts
/// of the outline of a region, which is on their left. From the end of a chain, the result follows
/// the border counter-clockwise to the next start of a chain (K. Weiler and P. Atherton, "Hidden
/// surface removal using polygon area sorting", 1977). Closed chains are returned unchanged.
/// Precondition: open chains begin and end on the border and do not cross each other.
std::vector<Chain> closed_along_border(std::vector<Chain> chains, double width, double height);

}  // namespace foam::texgen
