// SPDX-License-Identifier: Apache-2.0

#include "texgen/mesh/normals.h"

#include "core/parallel/counting_sort.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

namespace foam::texgen {

namespace {

using Vector3 = std::array<double, 3>;

constexpr double kSmoothCosine = 0.8660254037844386;  // the cosine of 30 degrees

Point3 to_float(const Vector3& vector) {
    return {static_cast<float>(vector[0]),
            static_cast<float>(vector[1]),
            static_cast<float>(vector[2])};
}

// Returns the corners of all triangles, in one bucket per point. Corner 3 t + k is corner k of
// triangle t.
Buckets<std::uint32_t> corners_of(const Mesh& mesh) {
    return counting_sort<std::uint32_t>(
        mesh.positions.size(), 1, 1, [&](std::size_t, const auto& put) {
            std::uint32_t corner = 0;
            for (const Triangle& triangle : mesh.triangles) {
                for (const std::uint32_t point : triangle) {
                    put(point, corner++);
                }
            }
        });
}

// Computes the normals of the corners at a point, and adds a point for each different normal.
class NormalsOfPoint {
  public:
    explicit NormalsOfPoint(const Mesh& mesh) : mesh_(mesh) {}

    void add(std::uint32_t point, std::span<const std::uint32_t> corners, MeshWithNormals& result) {
        areas_.clear();
        directions_.clear();
        for (const std::uint32_t corner : corners) {
            areas_.push_back(area_vector(mesh_, mesh_.triangles[corner / 3]));
            directions_.push_back(normalized(areas_.back()));
        }
        give_direction_to_flat_triangles();
        const std::size_t first = result.positions.size();
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const Point3 normal = to_float(normalized(sum_of_similar(k)));
            result.triangles[corners[k] / 3][corners[k] % 3] = index_of(normal, first, result);
            if (result.positions.size() < result.normals.size()) {
                result.positions.push_back(mesh_.positions[point]);
            }
        }
    }

  private:
    // Gives the triangles without area, which have no direction of their own, the direction of the
    // first triangle with an area. Triangles without area are invisible, so any direction will do.
    void give_direction_to_flat_triangles() {
        const auto found =
            std::ranges::find_if(areas_, [](const Vector3& area) { return area != Vector3{}; });
        if (found != areas_.end()) {
            std::ranges::replace(directions_, Vector3{}, normalized(*found));
        }
    }

    // Returns the sum of the area vectors of those triangles at the point whose directions differ
    // from the direction of triangle k by less than 30 degrees.
    Vector3 sum_of_similar(std::size_t k) const {
        Vector3 sum{0.0, 0.0, 0.0};
        for (std::size_t m = 0; m < areas_.size(); ++m) {
            const Vector3& a = directions_[k];
            const Vector3& b = directions_[m];
            if (m == k || a[0] * b[0] + a[1] * b[1] + a[2] * b[2] > kSmoothCosine) {
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    sum[axis] += areas_[m][axis];
                }
            }
        }
        return sum;
    }

    // Returns the index of a normal among the normals from index `first` on. A new normal is
    // appended.
    static std::uint32_t index_of(const Point3& normal,
                                  std::size_t first,
                                  MeshWithNormals& result) {
        std::size_t index = first;
        while (index < result.normals.size() && result.normals[index] != normal) {
            ++index;
        }
        if (index == result.normals.size()) {
            result.normals.push_back(normal);
        }
        return static_cast<std::uint32_t>(index);
    }

    const Mesh& mesh_;
    std::vector<Vector3> areas_;       // the area_vector of each triangle at the point
    std::vector<Vector3> directions_;  // the vectors in `areas_`, normalized
};

}  // namespace

MeshWithNormals with_normals(const Mesh& mesh) {
    const Buckets<std::uint32_t> corners = corners_of(mesh);
    MeshWithNormals result{{}, {}, std::vector<Triangle>(mesh.triangles.size())};
    result.positions.reserve(mesh.positions.size());
    result.normals.reserve(mesh.positions.size());
    NormalsOfPoint normals(mesh);
    for (std::uint32_t point = 0; point < mesh.positions.size(); ++point) {
        normals.add(point, corners.items_of(point, point + 1), result);
    }
    return result;
}

}  // namespace foam::texgen
