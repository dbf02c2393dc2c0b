// SPDX-License-Identifier: Apache-2.0

#include "tests/core/patches.h"

#include "core/foam/polygon_mesh.h"

#include <cmath>
#include <cstdint>
#include <numbers>

namespace foam::test {

namespace {

constexpr std::uint32_t kSix = 6;

// Appends the corners of a regular hexagon around the origin. `angle` is the direction of the first
// corner, in radians.
void add_hexagon(double radius, double angle, std::vector<Vec2>& points) {
    for (std::uint32_t k = 0; k < kSix; ++k) {
        const double at = angle + std::numbers::pi / 3.0 * k;
        points.emplace_back(radius * std::cos(at), radius * std::sin(at));
    }
}

Foam with_targets(Foam foam, double area) {
    for (const BubbleId bubble : foam.network.bubbles()) {
        foam.target_areas[bubble] = area;
    }
    return foam;
}

// Returns six cells between two hexagons. Points 0 to 5 are on the inner hexagon, points 6 to 11 on
// the outer hexagon.
PolygonMesh hexagonal_ring() {
    PolygonMesh mesh;
    add_hexagon(0.6, 0.0, mesh.points);
    add_hexagon(1.6, 0.0, mesh.points);
    for (std::uint32_t k = 0; k < kSix; ++k) {
        const std::uint32_t next = (k + 1) % kSix;
        mesh.cells.push_back({k, kSix + k, kSix + next, next});
    }
    return mesh;
}

}  // namespace

Foam double_bubble(double left_area, double right_area) {
    const PolygonMesh mesh{{{0.0, 0.6}, {0.0, -0.6}, {-0.8, 0.0}, {0.8, 0.0}},
                           {{0, 2, 1}, {1, 3, 0}}};
    Foam foam = foam_from_mesh(mesh);
    foam.target_areas[BubbleId{0}] = left_area;
    foam.target_areas[BubbleId{1}] = right_area;
    return foam;
}

Foam triple_bubble(double area) {
    const PolygonMesh mesh{{{0.0, 0.0}, {1.0, 0.0}, {-0.5, 0.8}, {-0.5, -0.8}},
                           {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}}};
    return with_targets(foam_from_mesh(mesh), area);
}

Foam flower(double area) {
    PolygonMesh mesh = hexagonal_ring();
    mesh.cells.insert(mesh.cells.begin(), {0, 1, 2, 3, 4, 5});
    return with_targets(foam_from_mesh(mesh), area);
}

Foam ring() {
    return with_targets(foam_from_mesh(hexagonal_ring()), 1.0);
}

Foam chain() {
    PolygonMesh mesh;
    for (std::uint32_t k = 0; k < 5; ++k) {
        mesh.points.emplace_back(k, 0.0);
        mesh.points.emplace_back(k, 1.0);
    }
    for (std::uint32_t k = 0; k < 8; k += 2) {
        mesh.cells.push_back({k, k + 2, k + 3, k + 1});
    }
    return with_targets(foam_from_mesh(mesh), 1.0);
}

}  // namespace foam::test
