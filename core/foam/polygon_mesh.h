// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"

#include <cstdint>
#include <vector>

namespace foam {

/// Polygons in the plane that share corners. A side that belongs to only one cell is at the outer
/// boundary or at a hole.
struct PolygonMesh {
    // The corners of a cell, counter-clockwise, as indices into `points`.
    using Cell = std::vector<std::uint32_t>;

    std::vector<Vec2> points;
    std::vector<Cell> cells;
};

/// Returns the area of a cell of the mesh.
double polygon_area(const PolygonMesh& mesh, const PolygonMesh::Cell& cell);

/// Returns the mesh as a patch with straight films and pressures of 0. Bubbles are the cells, in
/// the same order; target areas are the areas of the cells. A chain of sides becomes one film: a
/// point where only two sides meet is dissolved. Throws std::runtime_error in three cases:
/// - a corner does not join two or three sides;
/// - two cells use one side in the same direction;
/// - a cell has no corner that joins three sides.
Foam foam_from_mesh(const PolygonMesh& mesh);

}  // namespace foam
