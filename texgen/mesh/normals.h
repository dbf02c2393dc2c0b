// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/mesh/mesh.h"

#include <cstdint>
#include <vector>

namespace foam::texgen {

/// A mesh whose points have normals. A point of the original mesh is several points here if the
/// corners of triangles at this point have different normals, for example at a crease.
struct MeshWithNormals {
    std::vector<Point3> positions;
    std::vector<Point3> normals;  // of length 1
    std::vector<Triangle> triangles;
};

/// Adds normals. The normal of a corner of a triangle is a mean of the normals of triangles at the
/// same point, weighted by area. Only normals that differ from the normal of the triangle by less
/// than 30 degrees are included. Curved surfaces therefore look smooth, and edges look sharp. A
/// triangle without area counts, at each of its points, as having the normal of another triangle at
/// this point. Precondition: at each point, at least one triangle has an area.
MeshWithNormals with_normals(const Mesh& mesh);

}  // namespace foam::texgen
