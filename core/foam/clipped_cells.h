#pragma once

#include "core/foam/cell_diagram.h"
#include "core/foam/outline.h"
#include "core/foam/polygon_mesh.h"

namespace foam {

/// Cells cut off at an outline.
struct ClippedCells {
    PolygonMesh mesh;           // a cell in many parts is many cells
    std::vector<Vec2> centres;  // of the largest part of each cell of the diagram; for those
                                // without any part, the middle of its corners
};

/// The diagram must not wrap around its torus anywhere near the outline.
ClippedCells clip_cells(const Outline& outline, const CellDiagram& diagram);

/// Area within the corners of a cell.
double polygon_area(const PolygonMesh& mesh, const PolygonMesh::Cell& cell);

/// Merges every cell that is much smaller than the mean into the neighbour with which it shares the
/// longest border, as long as what comes out is in one piece and has no hole. What then has no
/// neighbour, or too small a share of the rest, is left out.
void merge_slivers(PolygonMesh& mesh);

}  // namespace foam
