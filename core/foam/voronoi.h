#pragma once

#include "core/foam/cell_diagram.h"

#include <vector>

namespace foam {

/// The Voronoi diagram of sites on a torus. Sites are rounded to a grid of 2^-26 of the torus'
/// longer side, where the diagram is exact. Throws std::runtime_error where two sites fall
/// together. Where four lie on one circle, a corner joins more than three cells, which
/// foam_from_cells refuses.
CellDiagram voronoi_cells(const Domain& domain, const std::vector<Vec2>& sites);

}  // namespace foam
