// SPDX-License-Identifier: Apache-2.0

#include "texgen/mesh/glb_mesh.h"

#include "texgen/mesh/glb_builder.h"
#include "texgen/mesh/normals.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace foam::texgen {

namespace {

constexpr double kMeters = 0.001;  // meters per millimeter

// Turns vectors from z up to y up, and multiplies them by a factor.
std::vector<float> turned(std::span<const Point3> vectors, double factor) {
    std::vector<float> numbers;
    numbers.reserve(3 * vectors.size());
    const auto scaled = [&](float number) {
        return static_cast<float>(factor * static_cast<double>(number));
    };
    for (const auto& [x, y, z] : vectors) {
        // 0 - y is 0 if y is 0; the plain negative of y would then be -0.
        numbers.insert(numbers.end(), {scaled(x), scaled(z), 0.0F - scaled(y)});
    }
    return numbers;
}

Json limits_of(std::span<const float> positions) {
    Point3 low{positions[0], positions[1], positions[2]};
    Point3 high = low;
    for (std::size_t k = 0; k < positions.size(); ++k) {
        low[k % 3] = std::min(low[k % 3], positions[k]);
        high[k % 3] = std::max(high[k % 3], positions[k]);
    }
    return {{"min", low}, {"max", high}};
}

std::vector<std::uint32_t> corners_of(std::span<const Triangle> triangles) {
    std::vector<std::uint32_t> corners;
    corners.reserve(3 * triangles.size());
    for (const Triangle& triangle : triangles) {
        corners.insert(corners.end(), triangle.begin(), triangle.end());
    }
    return corners;
}

}  // namespace

std::string to_glb(const Mesh& mesh, std::string_view name) {
    GlbBuilder builder(name);
    {
        const MeshWithNormals shaded = with_normals(mesh);
        const std::vector<float> positions = turned(shaded.positions, kMeters);
        Json attributes;
        attributes["POSITION"] = builder.add_vectors(positions, 3, limits_of(positions));
        attributes["NORMAL"] = builder.add_vectors(turned(shaded.normals, 1.0), 3, Json::object());
        const std::size_t corners =
            builder.add_corners(std::span<const std::uint32_t>(corners_of(shaded.triangles)));
        builder.set_mesh(name, {{"attributes", attributes}, {"indices", corners}});
    }
    const Bytes file = builder.file();
    return {reinterpret_cast<const char*>(file.data()), file.size()};
}

}  // namespace foam::texgen
