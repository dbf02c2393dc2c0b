// SPDX-License-Identifier: Apache-2.0

#include "core/foam/polygon_mesh.h"

#include "core/network/ghost_boundary.h"

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>

namespace foam {

namespace {

using Point = std::uint32_t;
using Side = std::pair<Point, Point>;  // from corner to corner

constexpr std::size_t kFilmsOfJunction = 3;

// Builds the network of a patch. Points where three sides meet become junctions. Each chain of
// sides between two junctions becomes one film. The first of the two cells beside a film adds the
// film; the second cell finds its half-edge of the film in `half_edges_`. Half-edges without a cell
// belong to the ghost.
class PatchBuilder {
  public:
    explicit PatchBuilder(const PolygonMesh& mesh) : mesh_(mesh) {}

    Foam build() {
        add_sides();
        add_bubbles();
        add_films();
        link_cells();
        add_ghost_boundary(foam_.network);
        foam_.t1_armed.resize(foam_.network.film_slots(), 1);
        complete_patch(foam_);
        return std::move(foam_);
    }

  private:
    // Collects the directed sides, and adds a junction at each point where three sides meet.
    void add_sides() {
        std::vector<std::vector<Point>> neighbors(mesh_.points.size());
        for (const PolygonMesh::Cell& corners : mesh_.cells) {
            for (std::size_t k = 0; k < corners.size(); ++k) {
                const Side side{corners[k], corners[(k + 1) % corners.size()]};
                if (!sides_.insert(side).second) {
                    throw std::runtime_error(
                        "polygon mesh: two cells are on the same side of an edge");
                }
                neighbors[side.first].push_back(side.second);
                neighbors[side.second].push_back(side.first);
            }
        }
        junctions_.assign(mesh_.points.size(), kNone<JunctionId>);
        for (Point point = 0; point < neighbors.size(); ++point) {
            add_junction(point, neighbors[point]);
        }
    }

    // Adds a junction if the point has three neighbors. A neighbor may occur twice in `neighbors`:
    // the side from the point to this neighbor may belong to two cells, each of which adds the
    // neighbor. Throws std::runtime_error if the point has one neighbor or more than three.
    void add_junction(Point point, std::vector<Point>& neighbors) {
        std::sort(neighbors.begin(), neighbors.end());
        neighbors.erase(std::unique(neighbors.begin(), neighbors.end()), neighbors.end());
        if (neighbors.size() > kFilmsOfJunction || neighbors.size() == 1) {
            throw std::runtime_error("polygon mesh: a point does not join two or three edges");
        }
        if (neighbors.size() == kFilmsOfJunction) {
            junctions_[point] = foam_.network.add_junction();
            foam_.positions.push_back(mesh_.points[point]);
        }
    }

    bool is_junction(Point point) const { return junctions_[point] != kNone<JunctionId>; }

    void add_bubbles() {
        for (const PolygonMesh::Cell& corners : mesh_.cells) {
            foam_.network.add_bubble();
            foam_.pressures.push_back(0.0);
            foam_.target_areas.push_back(polygon_area(mesh_, corners));
            foam_.identities.push_back(foam_.next_identity++);
        }
    }

    // Adds a film for each chain of sides from junction to junction. Stores the half-edges around
    // each cell in `loops_`.
    void add_films() {
        for (std::size_t cell = 0; cell < mesh_.cells.size(); ++cell) {
            const PolygonMesh::Cell& corners = mesh_.cells[cell];
            const auto start = std::find_if(
                corners.begin(), corners.end(), [this](Point point) { return is_junction(point); });
            if (start == corners.end()) {
                throw std::runtime_error(
                    "polygon mesh: a cell has no corner that joins three edges");
            }
            PolygonMesh::Cell turned(start, corners.end());
            turned.insert(turned.end(), corners.begin(), start);
            turned.push_back(*start);
            loops_.push_back(half_edges_along(turned, id_at<BubbleId>(cell)));
        }
    }

    // Returns the half-edges of a cell in order, with `bubble` set as their left bubble. `corners`
    // starts and ends with the same junction.
    std::vector<HalfEdgeId> half_edges_along(const PolygonMesh::Cell& corners, BubbleId bubble) {
        std::vector<HalfEdgeId> loop;
        std::size_t begin = 0;
        for (std::size_t end = 1; end < corners.size(); ++end) {
            if (is_junction(corners[end])) {
                const HalfEdgeId h = half_edge_along(corners, begin, end);
                foam_.network.set_left(h, bubble);
                loop.push_back(h);
                begin = end;
            }
        }
        return loop;
    }

    // Returns the half-edge of the chain of sides from corner `begin` to corner `end`. Adds the
    // film unless the cell on the other side has already added it.
    HalfEdgeId half_edge_along(const PolygonMesh::Cell& corners,
                               std::size_t begin,
                               std::size_t end) {
        const auto known = half_edges_.find({corners[begin], corners[begin + 1]});
        if (known != half_edges_.end()) {
            return known->second;
        }
        const HalfEdgeId h = forward_side(foam_.network.add_film());
        half_edges_[{corners[end], corners[end - 1]}] = twin(h);
        foam_.network.set_tail(h, junctions_[corners[begin]]);
        foam_.network.set_tail(twin(h), junctions_[corners[end]]);
        return h;
    }

    void link_cells() {
        for (std::size_t cell = 0; cell < loops_.size(); ++cell) {
            const std::vector<HalfEdgeId>& loop = loops_[cell];
            const auto bubble = id_at<BubbleId>(cell);
            foam_.network.set_first(bubble, loop.front());
            foam_.network.set_sides(bubble, static_cast<int>(loop.size()));
            for (std::size_t k = 0; k < loop.size(); ++k) {
                foam_.network.set_next(loop[k], loop[(k + 1) % loop.size()]);
            }
        }
    }

    const PolygonMesh& mesh_;
    Foam foam_;
    std::set<Side> sides_;
    std::vector<JunctionId> junctions_;           // per point; kNone unless three sides meet
    std::map<Side, HalfEdgeId> half_edges_;       // by the first side of the chain
    std::vector<std::vector<HalfEdgeId>> loops_;  // per cell
};

}  // namespace

double polygon_area(const PolygonMesh& mesh, const PolygonMesh::Cell& cell) {
    double twice_area = 0.0;
    for (std::size_t k = 0; k + 1 < cell.size(); ++k) {
        twice_area += cross(mesh.points[cell[k]] - mesh.points[cell[0]],
                            mesh.points[cell[k + 1]] - mesh.points[cell[0]]);
    }
    return 0.5 * twice_area;
}

Foam foam_from_mesh(const PolygonMesh& mesh) {
    return PatchBuilder(mesh).build();
}

}  // namespace foam
