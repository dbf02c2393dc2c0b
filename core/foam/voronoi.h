#pragma once

#include "core/foam/cell_diagram.h"

#include <vector>

namespace foam {

/// The Voronoi diagram of sites on a torus. Sites are rounded to a grid of 2^-26 of the torus'
/// longer side, where the diagram is exact. Throws std::runtime_error where two sites fall together
/// or four lie on one circle, so that a corner would join more than three cells.
CellDiagram voronoi_cells(const Torus& torus, const std::vector<Vec2>& sites);

}  // namespace foam
