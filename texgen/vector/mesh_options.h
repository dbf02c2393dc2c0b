// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/keys/key.h"

namespace foam::texgen {

/// The kind of solid that a mesh shows.
enum class MeshKind {
    Auto,    // walls if drawings show a maze or contours (VectorContent), otherwise the relief
    Relief,  // the surface of the map `height`, on a slab
    Walls,   // the lines of a drawing (films, walls of a maze, contours), as walls of equal height
};

/// The options of meshes: STL and GLB files. Meshes have the same width as drawings
/// (VectorOptions::width_mm). Lengths are in millimeters.
struct MeshOptions {
    MeshKind kind = MeshKind::Auto;
    // Thickness of the slab under the lowest point of a relief, or of the plate under walls; 0 for
    // walls without a plate. A relief needs a thickness above 0 (check_mesh).
    double base_mm = 2.0;
    // Height of the highest point of a relief above the lowest one; 0 for the true scale, at which
    // heights and widths have the same unit.
    double relief_mm = 0.0;
    double wall_mm = 3.0;  // height of walls above the plate
    // The largest distance between an arc of a wall and the polygon that replaces it.
    double tolerance_mm = 0.02;
};

/// Returns the keys of the table `mesh` of a preset, without the prefix "mesh.".
Keys<MeshOptions> mesh_keys();

}  // namespace foam::texgen
