// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/geometry/vec2.h"
#include "texgen/mesh/edges.h"

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

namespace foam::texgen {

/// A closed polygon, as its corners.
using Ring = std::vector<Vec2>;

/// A grid of positions that single precision represents exactly. Meshes are stored in single
/// precision. If points were rounded only after the triangulation, thin triangles could turn over.
class PrintGrid {
  public:
    /// `extent` is the largest absolute value of a coordinate. The step of the grid is the largest
    /// power of two below extent / 2^21, but at least 2^-40.
    explicit PrintGrid(double extent);

    /// Returns the position of the grid that is nearest to a point.
    Vec2 operator()(const Vec2& point) const;
    /// Returns the distance between adjacent positions.
    double step() const { return step_; }

  private:
    double step_;
};

/// Points on a grid. Each point has an index.
class PointTable {
  public:
    explicit PointTable(const PrintGrid& grid) : grid_(grid) {}

    /// Returns the index of the point of the grid that is nearest to `point`.
    /// If the table does not contain this point yet, appends it.
    std::uint32_t index_of(const Vec2& point);
    const Vec2& operator[](std::uint32_t index) const { return points_[index]; }
    std::size_t size() const { return points_.size(); }

  private:
    PrintGrid grid_;
    std::vector<Vec2> points_;
    std::unordered_map<std::uint64_t, std::uint32_t> indices_;
};

/// Adds the corners of a ring to `points`, which moves them to its grid, and returns the edges
/// between the moved corners. Edges between equal points are left out.
std::vector<Edge> edges_of(const Ring& ring, PointTable& points);

/// Returns the edges in ascending order. An edge and its opposite cancel each other.
std::vector<Edge> without_opposites(std::vector<Edge> edges);

/// Returns counter-clockwise triangles of the region in which the winding number of the edges is
/// positive. The tessellator of GLU, a sweep-line algorithm, adds a point where edges cross; all
/// other points of the triangles are points of the edges. The corners of a triangle are different
/// points, but they can be on one line. Precondition: the edges are in ascending order, and at each
/// point, as many edges end as begin. Throws std::bad_alloc if the machine has too little memory.
std::vector<Triangle> triangles_of(std::span<const Edge> edges, PointTable& points);

}  // namespace foam::texgen
