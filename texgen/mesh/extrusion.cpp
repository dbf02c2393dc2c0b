// SPDX-License-Identifier: Apache-2.0

#include "texgen/mesh/extrusion.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <span>
#include <stdexcept>
#include <utility>

// The solid has horizontal faces: the tops of the walls, the floors, and the bottom. The floors are
// the top of the plate between the walls; without a plate there are none. The bottom consists of
// the triangles of walls and floors. The sides are the edges of the plate and of the border of the
// walls, extruded.
//
// The tessellator is called for the walls and for the floors. It is also called once for the plate,
// to find the border of the union of its rings. The border of the floors is computed from the edges
// of the triangles of the walls. Triangles of walls and floors therefore share all edges and
// points.

namespace foam::texgen {

namespace {

// The triangles of a flat region, and their border.
struct Region {
    std::vector<Triangle> triangles;
    std::vector<Edge> border;
};

[[noreturn]] void reject() {
    throw std::invalid_argument(
        "the mesh of the walls would not be closed, usually because walls touch each other in a "
        "point: choose another vector.wall_width or mesh.tolerance_mm");
}

Region region_of(std::span<const Edge> edges, PointTable& points) {
    Region region{triangles_of(edges, points), {}};
    const std::vector<Edge> sides = sorted_edges(region.triangles);
    if (!are_distinct(sides)) {
        reject();
    }
    region.border = unpaired(sides);
    return region;
}

std::vector<Edge> edges_of(std::span<const Ring> rings, PointTable& points) {
    std::vector<Edge> edges;
    for (const Ring& ring : rings) {
        std::ranges::copy(edges_of(ring, points), std::back_inserter(edges));
    }
    return without_opposites(std::move(edges));
}

// Divides each edge of a plate at the points of walls that are on this edge. Where walls end at the
// border of the plate, this border then consists of edges of walls and edges between walls.
std::vector<Edge> divided(std::span<const Edge> edges,
                          std::span<const Edge> walls,
                          const PointTable& points) {
    std::vector<Edge> parts;
    for (const Edge edge : edges) {
        const Vec2& start = points[start_of(edge)];
        const Vec2 along = points[end_of(edge)] - start;
        std::vector<std::pair<double, std::uint32_t>> stops{{0.0, start_of(edge)},
                                                            {along.squaredNorm(), end_of(edge)}};
        for (const Edge wall : walls) {
            const Vec2 offset = points[start_of(wall)] - start;
            const double position = offset.dot(along);
            if (cross(along, offset) == 0.0 && position > 0.0 && position < along.squaredNorm()) {
                stops.emplace_back(position, start_of(wall));
            }
        }
        std::ranges::sort(stops);
        for (std::size_t k = 0; k + 1 < stops.size(); ++k) {
            parts.push_back(edge_between(stops[k].second, stops[k + 1].second));
        }
    }
    return parts;
}

// Builds the mesh level by level. A point of the plane becomes at most one point of the mesh per
// level.
class Levels {
  public:
    explicit Levels(const PointTable& points) : points_(points) {}

    /// Adds triangles at a height. They face up or, if `is_below` is true, down.
    void add_faces(std::span<const Triangle> triangles, double height, bool is_below) {
        Level level(*this, height);
        for (const auto& [a, b, c] : triangles) {
            mesh_.triangles.push_back(is_below ? Triangle{level(a), level(c), level(b)}
                                               : Triangle{level(a), level(b), level(c)});
        }
    }

    /// Adds vertical rectangles over edges whose left side is inside of the solid.
    void add_sides(std::span<const Edge> edges, double low, double high) {
        Level lower(*this, low);
        Level upper(*this, high);
        for (const Edge edge : edges) {
            const std::uint32_t a = start_of(edge);
            const std::uint32_t b = end_of(edge);
            mesh_.triangles.push_back({lower(a), lower(b), upper(b)});
            mesh_.triangles.push_back({lower(a), upper(b), upper(a)});
        }
    }

    Mesh take() { return std::move(mesh_); }

  private:
    // The points of the mesh at one height. The first call with a point of the plane adds the point
    // of the mesh at this height. Every call returns the index of that point of the mesh.
    class Level {
      public:
        Level(Levels& owner, double height)
            : owner_(owner), height_(height), indices_(owner.indices_at(height)) {}

        std::uint32_t operator()(std::uint32_t point) {
            if (indices_[point] == kNone) {
                const Vec2& position = owner_.points_[point];
                indices_[point] = static_cast<std::uint32_t>(owner_.mesh_.positions.size());
                owner_.mesh_.positions.push_back({static_cast<float>(position.x()),
                                                  static_cast<float>(position.y()),
                                                  static_cast<float>(height_)});
            }
            return indices_[point];
        }

      private:
        Levels& owner_;
        double height_;
        std::vector<std::uint32_t>& indices_;
    };

    static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

    std::vector<std::uint32_t>& indices_at(double height) {
        return indices_.try_emplace(height, points_.size(), kNone).first->second;
    }

    const PointTable& points_;
    Mesh mesh_;
    std::map<double, std::vector<std::uint32_t>> indices_;
};

Mesh without_plate(const Region& walls, const PointTable& points, double height) {
    Levels levels(points);
    levels.add_faces(walls.triangles, 0.0, true);
    levels.add_faces(walls.triangles, height, false);
    levels.add_sides(walls.border, 0.0, height);
    return levels.take();
}

Mesh with_plate(const Region& walls,
                std::span<const Edge> plate,
                PointTable& points,
                const Extrusion& extrusion) {
    const std::vector<Edge> outer = extrusion.reaches_border
                                        ? divided(plate, walls.border, points)
                                        : std::vector(plate.begin(), plate.end());
    std::vector<Edge> edges = outer;
    std::ranges::transform(walls.border, std::back_inserter(edges), opposite);
    const std::vector<Edge> around_floors = without_opposites(std::move(edges));
    const Region floors = region_of(around_floors, points);
    if (floors.border != around_floors) {
        reject();
    }
    const double base = extrusion.base_height;
    const double top = base + extrusion.wall_height;
    Levels levels(points);
    for (const Region* const region : {&walls, &floors}) {
        levels.add_faces(region->triangles, 0.0, true);
    }
    levels.add_faces(floors.triangles, base, false);
    levels.add_faces(walls.triangles, top, false);
    levels.add_sides(outer, 0.0, base);
    levels.add_sides(walls.border, base, top);
    return levels.take();
}

double extent_of(const Extrusion& extrusion) {
    double extent = 0.0;
    for (const std::vector<Ring>* const rings : {&extrusion.walls, &extrusion.plate}) {
        for (const Ring& ring : *rings) {
            for (const Vec2& corner : ring) {
                extent = std::max(extent, corner.cwiseAbs().maxCoeff());
            }
        }
    }
    return extent;
}

}  // namespace

Mesh extruded(const Extrusion& extrusion) {
    PointTable points{PrintGrid(extent_of(extrusion))};
    const std::vector<Edge> around_walls = edges_of(extrusion.walls, points);
    const Region walls = region_of(around_walls, points);
    const bool has_plate = extrusion.base_height > 0.0;
    // The border of the union of the rings of the plate.
    const std::vector<Edge> plate =
        has_plate ? region_of(edges_of(extrusion.plate, points), points).border
                  : std::vector<Edge>();
    Mesh mesh = has_plate ? with_plate(walls, plate, points, extrusion)
                          : without_plate(walls, points, extrusion.wall_height);
    if (!is_closed(mesh)) {
        reject();
    }
    return mesh;
}

}  // namespace foam::texgen
