// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/mesh/mesh.h"
#include "texgen/vector/vector_source.h"

namespace foam::texgen {

/// Returns what a mesh shows. Does not return MeshKind::Auto.
MeshKind shown_kind(const VectorSettings& settings);

/// Throws std::invalid_argument if a mesh is not possible: a relief without a base or with more
/// than kMaxTriangles triangles, or walls without a width.
void check_mesh(const VectorSettings& settings);

/// Returns the solid of a frame as a closed mesh in millimeters, with z up.
///
/// The surface of a relief passes through the height of each pixel of the image. On a torus, the
/// heights of the first column and row are repeated beyond the last ones, so that the slab is as
/// wide as the tile and copies of it fit together. (The slab is displaced by half a pixel against a
/// drawing.) If the torus is sheared, the repetition of the first row is displaced by the shear. In
/// a view of the plane, the outermost heights continue to the border.
///
/// Walls have the outlines of the drawing. On a torus whose tile cuts them, the plate is the tile.
/// Otherwise, the plate has the outline of all films, half a wall width away from the walls.
///
/// Throws std::invalid_argument as check_mesh, page_of and wall_outlines do, if there
/// are no walls, if walls touch in a point, and if they have more than kMaxTriangles triangles.
Mesh frame_mesh(const VectorSource& source);

}  // namespace foam::texgen
