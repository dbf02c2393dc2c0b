// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/cell_diagram.h"

#include <vector>

namespace foam {

/// Returns the Voronoi diagram of sites on a torus. Sites are rounded to a grid of 2^-26 of the
/// torus' longer side, on which the diagram is exact. If four sites are on one circle, a corner may
/// join more than three cells; foam_from_cells rejects such a diagram. Throws std::runtime_error if
/// two sites share a grid point, or if the sites leave too large a gap, for example a few sites on
/// a very long torus. Precondition: the torus has no shear.
CellDiagram voronoi_cells(const Domain& domain, const std::vector<Vec2>& sites);

}  // namespace foam
