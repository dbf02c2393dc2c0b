// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/cell_diagram.h"

#include <vector>

namespace foam {

/// Returns the Voronoi diagram of sites on a torus. Sites are rounded to a grid of 2^-26 of the
/// torus' longer side, on which the diagram is exact. If four sites are on one circle, a corner
/// joins more than three cells, which foam_from_cells rejects. Throws std::runtime_error if two
/// sites share a grid point, or if the sites leave too large a gap, as few sites do on a very long
/// torus.
CellDiagram voronoi_cells(const Domain& domain, const std::vector<Vec2>& sites);

}  // namespace foam
