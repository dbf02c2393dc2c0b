// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/maps/maze_line.h"
#include "texgen/vector/page.h"

#include <vector>

namespace foam::texgen {

/// Returns a smooth curve through stations, which are points of the solution line of a maze. The
/// curve consists of arcs on the page, two between successive stations (a biarc: K. M. Bolton,
/// "Biarc curves", 1975). At each station, the curve has the direction of the station. On a torus,
/// the curve may leave the tile.
std::vector<DrawnArc> smooth_arcs(const std::vector<Station>& stations, const Page& page);

}  // namespace foam::texgen
