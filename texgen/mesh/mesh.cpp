// SPDX-License-Identifier: Apache-2.0

#include "texgen/mesh/mesh.h"

#include <cmath>
#include <cstdint>

namespace foam::texgen {

namespace {

using Vector3 = std::array<double, 3>;

Vector3 point(const Mesh& mesh, std::uint32_t index) {
    const Point3& p = mesh.positions[index];
    return {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
}

Vector3 difference(const Vector3& a, const Vector3& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

Vector3 cross_product(const Vector3& a, const Vector3& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double dot_product(const Vector3& a, const Vector3& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

}  // namespace

Vector3 area_vector(const Mesh& mesh, const Triangle& triangle) {
    const Vector3 a = point(mesh, triangle[0]);
    return cross_product(difference(point(mesh, triangle[1]), a),
                         difference(point(mesh, triangle[2]), a));
}

Vector3 normalized(const Vector3& vector) {
    const double length = std::sqrt(dot_product(vector, vector));
    return length > 0.0 ? Vector3{vector[0] / length, vector[1] / length, vector[2] / length}
                        : vector;
}

double volume(const Mesh& mesh) {
    double sum = 0.0;
    for (const Triangle& triangle : mesh.triangles) {
        sum += dot_product(point(mesh, triangle[0]), area_vector(mesh, triangle));
    }
    return sum / 6.0;
}

bool is_closed(const Mesh& mesh) {
    const std::vector<Edge> edges = sorted_edges(mesh.triangles);
    return are_distinct(edges) && unpaired(edges).empty();
}

}  // namespace foam::texgen
