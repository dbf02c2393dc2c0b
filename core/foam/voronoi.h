// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/cell_diagram.h"

#include <vector>

namespace foam {

/// Returns the Voronoi diagram of sites on a torus; cell k belongs to site k. Sites and periods are
/// rounded to a grid with a spacing of 2^-26 of the longer period of the torus. The diagram of the
/// rounded sites is exact, except that the coordinates of its corners are rounded. If four sites
/// are on one circle, a corner may join more than three cells; foam_from_cells rejects such a
/// diagram. Throws std::runtime_error if two sites share a grid point. Also throws
/// std::runtime_error if the gaps between sites are too large, for example if a very long torus has
/// few sites. Precondition: the torus has no shear, and the sites are in its fundamental cell.
CellDiagram voronoi_cells(const Domain& domain, const std::vector<Vec2>& sites);

}  // namespace foam
