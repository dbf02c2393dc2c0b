// SPDX-License-Identifier: Apache-2.0

#include "core/foam/clipped_cells.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

// Clips a Voronoi diagram to an outline and joins the parts to a mesh with shared points. Each cell
// is clipped separately, so that the cuts of neighboring cells agree only up to rounding. Points
// closer than a tolerance are therefore merged. To find them, the plane is divided into square
// boxes as large as the tolerance, and the 3 x 3 boxes around a point are searched. Finally, small
// parts (slivers) are merged with their neighbors, because slivers at the outline would become
// bubbles that vanish at once.

namespace foam {

namespace {

constexpr double kSamePoint = 1e-9;  // points closer than this distance, in foam units, are merged
constexpr double kSliverArea = 0.1;  // cells below this fraction of the mean area are merged

using Cell = PolygonMesh::Cell;
using Side = std::pair<std::uint32_t, std::uint32_t>;

// A set of points. A point closer than kSamePoint to a point of the set is merged with it.
class PointSet {
  public:
    explicit PointSet(std::vector<Vec2>& points) : points_(points) {}

    // Returns the index of a point of the set that is closer than kSamePoint to the given point. If
    // no point is that close, adds the given point and returns its index.
    std::uint32_t find_or_add(const Vec2& point) {
        const auto [x, y] = box_of(point);
        for (std::int64_t dx = -1; dx <= 1; ++dx) {
            for (std::int64_t dy = -1; dy <= 1; ++dy) {
                const auto [begin, end] = boxes_.equal_range({x + dx, y + dy});
                const auto near = std::find_if(begin, end, [&](const auto& entry) {
                    return (points_[entry.second] - point).norm() < kSamePoint;
                });
                if (near != end) {
                    return near->second;
                }
            }
        }
        const auto index = static_cast<std::uint32_t>(points_.size());
        points_.push_back(point);
        boxes_.insert({{x, y}, index});
        return index;
    }

  private:
    using Box = std::pair<std::int64_t, std::int64_t>;

    static Box box_of(const Vec2& point) {
        return {std::llround(point.x() / kSamePoint), std::llround(point.y() / kSamePoint)};
    }

    std::vector<Vec2>& points_;
    // A box may have several points, because its diagonal is longer than kSamePoint.
    std::multimap<Box, std::uint32_t> boxes_;
};

// Converts a ring (one part of a clipped cell) to a cell of the mesh. May return fewer than three
// points, because points are merged.
Cell cell_of_ring(const std::vector<Vec2>& ring, PointSet& points) {
    Cell cell;
    for (const Vec2& point : ring) {
        const std::uint32_t index = points.find_or_add(point);
        if (cell.empty() || (cell.back() != index && cell.front() != index)) {
            cell.push_back(index);
        }
    }
    return cell;
}

// Returns the lengths of the sides of a cell. Each key is a side in the direction in which the
// neighboring cell has it: from the end of the side to its start.
std::map<Side, double> reversed_sides(const PolygonMesh& mesh, const Cell& corners) {
    std::map<Side, double> sides;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const std::uint32_t a = corners[k];
        const std::uint32_t b = corners[(k + 1) % corners.size()];
        sides[{b, a}] = (mesh.points[b] - mesh.points[a]).norm();
    }
    return sides;
}

// Returns the total length of the given sides that are also sides of the cell.
double length_of(const std::map<Side, double>& sides, const Cell& corners) {
    double length = 0.0;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const auto found = sides.find({corners[k], corners[(k + 1) % corners.size()]});
        length += found == sides.end() ? 0.0 : found->second;
    }
    return length;
}

// Returns the neighbors of a cell, ordered by the length of the common border, the longest first.
std::vector<std::size_t> neighbors_of(const PolygonMesh& mesh, std::size_t cell) {
    const std::map<Side, double> sides = reversed_sides(mesh, mesh.cells[cell]);
    std::map<std::size_t, double> borders;
    for (std::size_t other = 0; other < mesh.cells.size(); ++other) {
        const double border = length_of(sides, mesh.cells[other]);
        if (border > 0.0) {
            borders[other] = border;
        }
    }
    std::vector<std::size_t> neighbors;
    neighbors.reserve(borders.size());
    for (const auto& [neighbor, length] : borders) {
        neighbors.push_back(neighbor);
    }
    std::stable_sort(neighbors.begin(), neighbors.end(), [&](std::size_t a, std::size_t b) {
        return borders[a] > borders[b];
    });
    return neighbors;
}

// Returns the union of two cells, or nothing if its boundary is not a single loop.
std::optional<Cell> merged(const Cell& a, const Cell& b) {
    // The successor of each point along the boundary of the union.
    std::map<std::uint32_t, std::uint32_t> next;
    std::size_t sides = 0;
    for (const auto& [own, other] : {std::pair(&a, &b), std::pair(&b, &a)}) {
        for (std::size_t k = 0; k < own->size(); ++k) {
            const std::uint32_t from = (*own)[k];
            const std::uint32_t to = (*own)[(k + 1) % own->size()];
            const auto corner = std::find(other->begin(), other->end(), to);
            const bool is_border =
                corner != other->end() &&
                (corner + 1 == other->end() ? other->front() : *(corner + 1)) == from;
            if (!is_border) {
                next[from] = to;
                ++sides;
            }
        }
    }
    if (next.empty() || next.size() != sides) {
        return std::nullopt;
    }
    Cell loop{next.begin()->first};
    for (std::uint32_t point = next.begin()->second;
         point != loop.front() && loop.size() <= sides;) {
        loop.push_back(point);
        const auto found = next.find(point);
        if (found == next.end()) {
            return std::nullopt;
        }
        point = found->second;
    }
    return loop.size() == sides ? std::optional(loop) : std::nullopt;
}

// Returns the unit in which the area of a cell is compared with the areas of other cells. The unit
// is the mean of the area field over the cell, or 1 if there is no area field.
double unit_area(const PolygonMesh& mesh, const Cell& cell, const AreaField* areas) {
    return areas != nullptr ? areas->mean_over(polygon_of(mesh, cell)) : 1.0;
}

// Returns the mean area of the cells, relative to the area field.
double mean_area(const PolygonMesh& mesh, const AreaField* areas) {
    double total = 0.0;
    double units = 0.0;
    for (const Cell& cell : mesh.cells) {
        total += polygon_area(mesh, cell);
        units += unit_area(mesh, cell, areas);
    }
    return total / units;
}

// Merges the cell into a neighbor and removes it from the mesh. The union of the neighbor and the
// cell must have a single loop as its boundary. Of several such neighbors, the one with the longest
// common border is chosen. If there is no such neighbor, the area of the cell is lost.
void merge_or_drop(PolygonMesh& mesh, std::size_t cell) {
    for (const std::size_t neighbor : neighbors_of(mesh, cell)) {
        if (const std::optional<Cell> both = merged(mesh.cells[cell], mesh.cells[neighbor])) {
            mesh.cells[neighbor] = *both;
            break;
        }
    }
    mesh.cells.erase(mesh.cells.begin() + static_cast<std::ptrdiff_t>(cell));
}

}  // namespace

std::vector<Vec2> polygon_of(const PolygonMesh& mesh, const Cell& cell) {
    std::vector<Vec2> polygon;
    polygon.reserve(cell.size());
    for (const std::uint32_t point : cell) {
        polygon.push_back(mesh.points[point]);
    }
    return polygon;
}

Vec2 lloyd_center(std::span<const Vec2> polygon, const AreaField* areas) {
    return areas != nullptr ? areas->centroid_of(polygon) : polygon_centroid(polygon);
}

ClippedCells clip_cells(const Outline& outline,
                        const CellDiagram& diagram,
                        const AreaField* areas) {
    ClippedCells clipped_cells;
    PolygonMesh& mesh = clipped_cells.mesh;
    PointSet points(mesh.points);
    for (const std::vector<CellCorner>& corners : diagram) {
        const std::vector<Vec2> ring = cell_polygon(corners);
        Vec2 center = lloyd_center(ring, areas);
        double largest = 0.0;
        for (const std::vector<Vec2>& part : clipped(outline, ring)) {
            const Cell cell = cell_of_ring(part, points);
            if (cell.size() < 3) {
                continue;
            }
            const double area = polygon_area(mesh, cell);
            if (area > largest) {
                largest = area;
                center = lloyd_center(polygon_of(mesh, cell), areas);
            }
            mesh.cells.push_back(cell);
        }
        clipped_cells.centers.push_back(center);
    }
    return clipped_cells;
}

void merge_slivers(PolygonMesh& mesh, const AreaField* areas) {
    const double min_area = kSliverArea * mean_area(mesh, areas);
    for (std::size_t cell = 0; cell < mesh.cells.size();) {
        const double unit = unit_area(mesh, mesh.cells[cell], areas);
        if (polygon_area(mesh, mesh.cells[cell]) < min_area * unit) {
            merge_or_drop(mesh, cell);
        } else {
            ++cell;
        }
    }
}

}  // namespace foam
