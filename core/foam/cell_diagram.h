#pragma once

#include "core/foam/foam.h"

#include <vector>

namespace foam {

/// A corner of a cell, and what lies across the side that leads from it to the next corner.
struct CellCorner {
    Vec2 point;            // in the plane, next to the cell's own site
    std::size_t across;    // the neighbouring cell ...
    LatticeOffset offset;  // ... of which the copy this many periods away is met
};

/// A tiling of the torus by polygons: per cell its corners, counter-clockwise.
using CellDiagram = std::vector<std::vector<CellCorner>>;

/// The tiling as a foam of straight films and pressure 0, whose target areas are the cells' areas
/// and whose bubbles are the cells in their order. Throws std::runtime_error where a corner does
/// not join exactly three cells, or the sides do not match up.
Foam foam_from_cells(const Domain& domain, const CellDiagram& cells);

/// Area within a cell's corners.
double cell_area(const std::vector<CellCorner>& cell);

/// Centre of the area within a cell's corners.
Vec2 cell_centroid(const std::vector<CellCorner>& cell);

}  // namespace foam
