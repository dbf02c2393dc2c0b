// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/mesh/mesh.h"
#include "texgen/vector/vector_source.h"

namespace foam::texgen {

/// Returns the kind of a mesh: MeshOptions::kind, unless it is MeshKind::Auto. For Auto, returns
/// Relief if the content of drawings (shown_content) is VectorContent::Foam, otherwise Walls.
MeshKind shown_kind(const VectorSettings& settings);

/// Throws std::invalid_argument if a mesh is not possible: a relief without a base or with more
/// than kMaxTriangles triangles, or walls without a width.
void check_mesh(const VectorSettings& settings);

/// Returns the solid of a frame as a closed mesh in millimeters, with z up.
///
/// A relief is a slab whose surface passes through the height of each pixel of the image. On a
/// torus, the heights of the first column and row are repeated beyond the last ones. The slab is
/// therefore as wide as the tile, and copies of it fit together. The slab of a torus is displaced
/// by half a pixel relative to a drawing of the frame. If the torus is sheared, the repetition of
/// the first row is displaced by the shear. In a view of the plane, the outermost heights continue
/// to the border.
///
/// Walls have the outlines of a drawing with VectorWalls::Outlines. They stand on a plate of the
/// height MeshOptions::base_mm; if this is 0, there is no plate. On a torus with VectorWrap::Cut,
/// the border of the tile cuts the walls, and the plate is the tile. Without such a cut, the plate
/// covers the foam, without holes, and extends one wall width beyond its outermost films.
///
/// Throws as check_mesh, page_of, appearance_of and wall_outlines do. Also throws
/// std::invalid_argument if there are no walls, if walls touch each other in a point, or if they
/// have more than kMaxTriangles triangles. Throws std::bad_alloc if the machine has too little
/// memory.
Mesh frame_mesh(const VectorSource& source);

}  // namespace foam::texgen
