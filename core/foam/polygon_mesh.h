#pragma once

#include "core/foam/foam.h"

#include <cstdint>
#include <vector>

namespace foam {

/// Polygons in the plane that share corners. Where a side belongs to one cell only, the outside or
/// a hole lies across it.
struct PolygonMesh {
    using Cell = std::vector<std::uint32_t>;  // indices of its corners, counter-clockwise

    std::vector<Vec2> points;
    std::vector<Cell> cells;
};

/// The mesh as a patch of straight films and pressure 0, whose target areas are the cells' areas
/// and whose bubbles are the cells in their order. Points that only two sides meet are dissolved,
/// so that a film may stand for many sides. Throws std::runtime_error where any other point does
/// not join exactly three sides, a side belongs to more than two cells, or no three cells or
/// outsides meet anywhere on a cell.
Foam foam_from_mesh(const PolygonMesh& mesh);

}  // namespace foam
