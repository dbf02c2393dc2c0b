// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/mesh/flat_region.h"
#include "texgen/mesh/mesh.h"

#include <cstddef>
#include <vector>

namespace foam::texgen {

/// Walls of a constant height, with or without a base plate. Lengths are in millimeters.
struct Extrusion {
    std::vector<Ring> walls;    // the region of the walls is on the left of the rings
    std::vector<Ring> plate{};  // contains the walls
    // True if walls end on the border of the plate. Every edge of the plate is then compared with
    // every edge of the walls, so the plate should have few corners.
    bool reaches_border = false;
    double base_height = 0.0;  // the height of the plate, from z = 0; 0 if there is no plate
    // The height of the walls above the plate, or above z = 0 if there is no plate.
    double wall_height = 0.0;
};

/// An extrusion has at most about this number of triangles per corner of its walls. Triangles at
/// the corners of the plate are not counted. For each corner, there are two triangles of a side of
/// the walls, and about one triangle in each of four faces: the top and the bottom of the walls,
/// and the top and the bottom of the floors (the parts of the plate that no wall covers).
inline constexpr std::size_t kTrianglesPerCorner = 6;

/// Returns the solid as one mesh. Horizontal coordinates are rounded to PrintGrid. Throws
/// std::invalid_argument if the mesh would not be closed, usually because walls touch each other in
/// a point, and std::bad_alloc if the machine has too little memory. Precondition: the plate
/// contains the walls.
Mesh extruded(const Extrusion& extrusion);

}  // namespace foam::texgen
