// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"

#include <cstdint>
#include <vector>

namespace foam {

/// Polygons in the plane that share corners. Across a side that belongs to one cell only is the
/// outside or a hole.
struct PolygonMesh {
    using Cell = std::vector<std::uint32_t>;  // indices of its corners, counter-clockwise

    std::vector<Vec2> points;
    std::vector<Cell> cells;
};

/// Returns the mesh as a patch of straight films and pressure 0. Bubbles are the cells in their
/// order; target areas are the areas of the cells. A point of only two sides is dissolved, so that
/// a film may replace a chain of sides. Throws std::runtime_error if a point of the cells has
/// neither two nor three sides, if two cells are on the same side of a side, or if a cell has no
/// corner of three sides.
Foam foam_from_mesh(const PolygonMesh& mesh);

}  // namespace foam
