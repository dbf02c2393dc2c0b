// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"

#include <span>
#include <vector>

namespace foam {

/// A corner of a cell, and the neighboring cell across the side that leads from this corner to the
/// next one.
struct CellCorner {
    Vec2 point;            // in the plane; corners are not wrapped into the fundamental cell
    std::size_t across;    // index of the neighboring cell
    LatticeOffset offset;  // lattice offset of the copy of the neighboring cell across the side
};

/// A tiling of the torus by polygons: the corners of each cell, counter-clockwise.
using CellDiagram = std::vector<std::vector<CellCorner>>;

/// Returns the tiling as a foam with straight films and pressures of 0. Bubbles are the cells, in
/// the same order; target areas are the areas of the cells. Throws std::runtime_error if a corner
/// does not join exactly three cells, or if a side has no counterpart in the cell across it.
/// Precondition: the torus has no shear.
Foam foam_from_cells(const Domain& domain, const CellDiagram& cells);

/// Returns the area of the polygon of a cell.
double cell_area(const std::vector<CellCorner>& cell);

/// Returns the corners of the polygon of a cell, counter-clockwise.
std::vector<Vec2> cell_polygon(const std::vector<CellCorner>& cell);

/// Returns the centroid of a polygon. Precondition: the polygon is counter-clockwise.
Vec2 polygon_centroid(std::span<const Vec2> polygon);

}  // namespace foam
