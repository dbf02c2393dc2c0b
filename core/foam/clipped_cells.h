// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/area_field.h"
#include "core/foam/cell_diagram.h"
#include "core/foam/outline.h"
#include "core/foam/polygon_mesh.h"

#include <span>
#include <vector>

namespace foam {

/// The cells of a diagram, clipped to an outline.
struct ClippedCells {
    // The outline may divide a cell of the diagram into several parts. The mesh has one cell for
    // each part that is within the outline.
    PolygonMesh mesh;
    std::vector<Vec2> centers;  // per cell of the diagram: lloyd_center of its largest part, or of
                                // the whole cell if no part is within the outline
};

/// Returns the point to which Lloyd's algorithm moves the site of a cell: the centroid of its
/// polygon, weighted if `areas` is not null (AreaField::centroid_of).
Vec2 lloyd_center(std::span<const Vec2> polygon, const AreaField* areas);

/// Clips the cells of a diagram on a torus to the outline. Precondition: no lattice copy of a cell
/// at an offset other than zero overlaps the outline. `areas` may be null.
ClippedCells clip_cells(const Outline& outline,
                        const CellDiagram& diagram,
                        const AreaField* areas = nullptr);

/// Returns the corners of a cell of the mesh, counter-clockwise.
std::vector<Vec2> polygon_of(const PolygonMesh& mesh, const PolygonMesh::Cell& cell);

/// Merges every cell smaller than a tenth of the mean area into the neighbor with which it shares
/// the longest border. If `areas` is not null, each area is compared relative to the mean of the
/// field over the cell (AreaField::mean_over). If the boundary of the union of the two cells is not
/// a single loop, tries the neighbor with the next longest border. Removes the small cell if no
/// neighbor is left to try.
void merge_slivers(PolygonMesh& mesh, const AreaField* areas = nullptr);

}  // namespace foam
