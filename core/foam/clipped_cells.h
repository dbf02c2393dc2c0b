// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/cell_diagram.h"
#include "core/foam/outline.h"
#include "core/foam/polygon_mesh.h"

namespace foam {

/// The cells of a diagram, clipped to an outline.
struct ClippedCells {
    PolygonMesh mesh;           // each part of a cell within the outline is a cell of the mesh
    std::vector<Vec2> centers;  // per cell of the diagram: the centroid of its largest part, or of
                                // the whole cell if no part is within the outline
};

/// Clips the cells to the outline. Precondition: the diagram does not wrap around its torus
/// anywhere near the outline.
ClippedCells clip_cells(const Outline& outline, const CellDiagram& diagram);

/// Returns the area of the polygon of a cell.
double polygon_area(const PolygonMesh& mesh, const PolygonMesh::Cell& cell);

/// Merges every cell below a tenth of the mean area into the neighbor with which it shares the
/// longest border, provided that the union is one piece without a hole; otherwise into the next
/// best neighbor. Removes a small cell that no neighbor can take.
void merge_slivers(PolygonMesh& mesh);

}  // namespace foam
