// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/geometry/vec2.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

namespace foam {

namespace detail {

/// The largest number of parts into which each side of a triangle is divided.
inline constexpr int kMaxDivisions = 32;

// Calls visit(centroid) for each of the n^2 equal triangles into which a triangle is divided.
template <class Visit>
void visit_parts(const std::array<Vec2, 3>& triangle, int n, const Visit& visit) {
    const Vec2 across = (triangle[1] - triangle[0]) / n;
    const Vec2 up = (triangle[2] - triangle[0]) / n;
    for (int j = 0; j < n; ++j) {
        for (int i = 0; i + j < n; ++i) {
            const Vec2 corner = triangle[0] + i * across + j * up;
            visit(Vec2(corner + (across + up) / 3.0));
            if (i + j + 1 < n) {
                visit(Vec2(corner + 2.0 * (across + up) / 3.0));
            }
        }
    }
}

}  // namespace detail

/// Calls visit(point, weight) for points that are spread evenly over a polygon; the sum of the
/// weights is the area of the polygon. The polygon is divided into triangles that share its first
/// corner. Each triangle is divided into n^2 equal parts, whose centroids are the points. The
/// number n is the smallest for which the sides of the parts are at most `spacing` long, but never
/// exceeds 32. If the polygon is not convex, some weights may be negative and some points outside.
/// Precondition: the polygon is counter-clockwise.
template <class Visit>
void visit_polygon_samples(std::span<const Vec2> polygon, double spacing, const Visit& visit) {
    for (std::size_t k = 1; k + 1 < polygon.size(); ++k) {
        const std::array<Vec2, 3> triangle{polygon[0], polygon[k], polygon[k + 1]};
        const double longest = std::max({(triangle[1] - triangle[0]).norm(),
                                         (triangle[2] - triangle[1]).norm(),
                                         (triangle[0] - triangle[2]).norm()});
        const double divisions = std::ceil(longest / spacing);
        const int n = static_cast<int>(std::clamp(divisions, 1.0, double{detail::kMaxDivisions}));
        const double area = 0.5 * cross(triangle[1] - triangle[0], triangle[2] - triangle[0]);
        const double weight = area / (static_cast<double>(n) * n);
        detail::visit_parts(triangle, n, [&](const Vec2& point) { visit(point, weight); });
    }
}

}  // namespace foam
