// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"

#include <vector>

namespace foam {

/// A corner of a cell, and the neighbor across the side that leads from it to the next corner.
struct CellCorner {
    Vec2 point;            // in the plane, next to the cell's own site
    std::size_t across;    // index of the neighboring cell
    LatticeOffset offset;  // lattice offset of the copy of the neighbor
};

/// A tiling of the torus by polygons: per cell its corners, counter-clockwise.
using CellDiagram = std::vector<std::vector<CellCorner>>;

/// Returns the tiling as a foam of straight films and pressure 0. Bubbles are the cells in their
/// order; target areas are the areas of the cells. Throws std::runtime_error if a corner does not
/// join exactly three cells, or if a side has no counterpart in the cell across it. Precondition:
/// the torus has no shear.
Foam foam_from_cells(const Domain& domain, const CellDiagram& cells);

/// Returns the area of the polygon of a cell.
double cell_area(const std::vector<CellCorner>& cell);

/// Returns the centroid of the polygon of a cell.
Vec2 cell_centroid(const std::vector<CellCorner>& cell);

}  // namespace foam
