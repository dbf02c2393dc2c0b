// SPDX-License-Identifier: Apache-2.0

#include "core/foam/cell_diagram.h"

#include <cmath>
#include <stdexcept>

// Builds the network of a foam from polygons that tile the torus. Each side of a cell becomes a
// half-edge. The cell across a side and the lattice offset of that cell identify the other
// half-edge of the same film. The corners of the three cells that meet at a point become one
// junction. Its position is this point, moved into the fundamental cell by whole periods. Each
// corner is therefore at a periodic copy of its junction. The lattice offset of a half-edge is the
// offset of the copy at its head minus the offset of the copy at its tail.

namespace foam {

namespace {

// The half-edge that starts at each corner, indexed by [cell][corner].
using HalfEdgeTable = std::vector<std::vector<HalfEdgeId>>;

// The side of `cell` that starts at `corner` is one half-edge of a film. The other half-edge is a
// side of the neighboring cell. Returns the index of the corner at which that side starts. Throws
// std::runtime_error if the neighboring cell has no such corner.
std::size_t matching_corner(const CellDiagram& cells, std::size_t cell, const CellCorner& corner) {
    const std::vector<CellCorner>& other = cells[corner.across];
    for (std::size_t k = 0; k < other.size(); ++k) {
        if (other[k].across == cell && other[k].offset == -corner.offset) {
            return k;
        }
    }
    throw std::runtime_error("cell diagram: an edge of a cell is missing in the neighboring cell");
}

// Adds one film for each edge of the tiling. Its two half-edges belong to the two cells beside the
// edge. Returns the half-edges of all cells.
HalfEdgeTable add_films(const CellDiagram& cells, Network& network) {
    HalfEdgeTable table(cells.size());
    for (std::size_t cell = 0; cell < cells.size(); ++cell) {
        table[cell].assign(cells[cell].size(), kNone<HalfEdgeId>);
    }
    for (std::size_t cell = 0; cell < cells.size(); ++cell) {
        for (std::size_t k = 0; k < cells[cell].size(); ++k) {
            if (table[cell][k] != kNone<HalfEdgeId>) {
                continue;
            }
            const HalfEdgeId h = forward_side(network.add_film());
            table[cell][k] = h;
            table[cells[cell][k].across][matching_corner(cells, cell, cells[cell][k])] = twin(h);
        }
    }
    return table;
}

void add_bubbles(const HalfEdgeTable& table, Network& network) {
    for (const std::vector<HalfEdgeId>& loop : table) {
        const BubbleId bubble = network.add_bubble();
        network.set_first(bubble, loop.front());
        network.set_sides(bubble, static_cast<int>(loop.size()));
        for (std::size_t k = 0; k < loop.size(); ++k) {
            network.set_left(loop[k], bubble);
            network.set_next(loop[k], loop[(k + 1) % loop.size()]);
        }
    }
}

// Adds a junction at the tail of h and sets it as the tail of the three half-edges that leave it.
void add_junction_at(HalfEdgeId h, const Vec2& point, Foam& foam) {
    const JunctionId junction = foam.network.add_junction();
    foam.positions.push_back(point - foam.domain.translation(foam.domain.cell_of(point)));
    HalfEdgeId leaving = h;
    for (int k = 0; k < 3; ++k) {
        foam.network.set_tail(leaving, junction);
        leaving = foam.network.next(twin(leaving));
    }
    if (leaving != h) {
        throw std::runtime_error("cell diagram: a corner does not join exactly three cells");
    }
}

// A junction has the stored position `junction`, and one of its lattice copies is at `point`.
// Returns the lattice offset of this copy.
LatticeOffset copy_of(const Domain& domain, const Vec2& point, const Vec2& junction) {
    const Vec2 apart = point - junction;
    return {static_cast<std::int32_t>(std::lround(apart.x() / domain.width)),
            static_cast<std::int32_t>(std::lround(apart.y() / domain.height))};
}

void add_junctions(const CellDiagram& cells, const HalfEdgeTable& table, Foam& foam) {
    std::vector<bool> has_tail(2 * foam.network.film_slots(), false);
    for (std::size_t cell = 0; cell < cells.size(); ++cell) {
        for (std::size_t k = 0; k < cells[cell].size(); ++k) {
            if (has_tail[index_of(table[cell][k])]) {
                continue;
            }
            add_junction_at(table[cell][k], cells[cell][k].point, foam);
            const JunctionId junction = foam.network.tail(table[cell][k]);
            for (const HalfEdgeId h : foam.network.leaving(junction)) {
                has_tail[index_of(h)] = true;
            }
        }
    }
}

void set_offsets(const CellDiagram& cells, const HalfEdgeTable& table, Foam& foam) {
    for (std::size_t cell = 0; cell < cells.size(); ++cell) {
        const std::vector<CellCorner>& corners = cells[cell];
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const HalfEdgeId h = table[cell][k];
            const Vec2& head = corners[(k + 1) % corners.size()].point;
            const Vec2& tail = corners[k].point;
            foam.network.set_offset(
                h,
                copy_of(foam.domain, head, foam.positions[foam.network.head(h)]) -
                    copy_of(foam.domain, tail, foam.positions[foam.network.tail(h)]));
        }
    }
}

}  // namespace

double cell_area(const std::vector<CellCorner>& cell) {
    double twice_area = 0.0;
    for (std::size_t k = 0; k + 1 < cell.size(); ++k) {
        twice_area += cross(cell[k].point - cell[0].point, cell[k + 1].point - cell[0].point);
    }
    return 0.5 * twice_area;
}

std::vector<Vec2> cell_polygon(const std::vector<CellCorner>& cell) {
    std::vector<Vec2> polygon;
    polygon.reserve(cell.size());
    for (const CellCorner& corner : cell) {
        polygon.push_back(corner.point);
    }
    return polygon;
}

Vec2 polygon_centroid(std::span<const Vec2> polygon) {
    Vec2 weighted = Vec2::Zero();
    double twice_area = 0.0;
    for (std::size_t k = 0; k + 1 < polygon.size(); ++k) {
        const Vec2 a = polygon[k] - polygon[0];
        const Vec2 b = polygon[k + 1] - polygon[0];
        weighted += cross(a, b) * (a + b) / 3.0;
        twice_area += cross(a, b);
    }
    return polygon[0] + weighted / twice_area;
}

Foam foam_from_cells(const Domain& domain, const CellDiagram& cells) {
    Foam foam;
    foam.domain = domain;
    const HalfEdgeTable table = add_films(cells, foam.network);
    add_bubbles(table, foam.network);
    add_junctions(cells, table, foam);
    set_offsets(cells, table, foam);
    foam.pressures.resize(cells.size(), 0.0);
    foam.t1_armed.resize(foam.network.film_slots(), 1);
    for (const std::vector<CellCorner>& cell : cells) {
        foam.target_areas.push_back(cell_area(cell));
        foam.identities.push_back(foam.next_identity++);
    }
    return foam;
}

}  // namespace foam
