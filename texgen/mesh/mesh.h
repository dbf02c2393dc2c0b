// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/mesh/edges.h"

#include <array>
#include <cstddef>
#include <vector>

namespace foam::texgen {

/// The largest number of triangles of a mesh. An STL file of this size has 1 GB.
inline constexpr std::size_t kMaxTriangles = 20'000'000;

/// A point of a mesh in millimeters, with z up.
using Point3 = std::array<float, 3>;
/// The surface of a solid as triangles that share their points. Triangles are counter-clockwise if
/// seen from outside of the solid.
struct Mesh {
    std::vector<Point3> positions;
    std::vector<Triangle> triangles;
};

/// Returns the cross product of two edges of a triangle: it points out of the solid, and its length
/// is twice the area of the triangle.
std::array<double, 3> area_vector(const Mesh& mesh, const Triangle& triangle);

/// Returns the vector divided by its length, or the vector itself if its length is 0.
std::array<double, 3> normalized(const std::array<double, 3>& vector);

/// Returns the volume inside of a closed mesh in cubic millimeters (divergence theorem).
double volume(const Mesh& mesh);

/// Returns true if every edge has exactly two triangles, which pass it in opposite directions. The
/// mesh is then a closed, consistently oriented surface (a 2-manifold, apart from points at which
/// parts of the surface touch).
bool is_closed(const Mesh& mesh);

}  // namespace foam::texgen
