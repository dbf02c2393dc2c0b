// SPDX-License-Identifier: Apache-2.0

#include "core/foam/voronoi.h"

#include <boost/polygon/voronoi.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

// The periodic diagram is part of a planar Voronoi diagram (Boost.Polygon). The planar diagram
// contains the sites, and their lattice copies within a margin around the fundamental cell of the
// torus. Each corner of a cell is the center of a circle through the sites of the cells that meet
// at this corner. A cell is final if all these circles are within the margin, because no copy
// farther away can then cut off a part of the cell. If a cell is not final, the margin is doubled
// and the diagram is computed again.

namespace foam {

namespace {

using Diagram = boost::polygon::voronoi_diagram<double>;
using GridPoint = boost::polygon::point_data<std::int32_t>;

// Number of grid points along the longer period of the torus.
constexpr double kGridPoints = 0x1.0p26;
// Largest number of copies of the fundamental cell on each side of it. Coordinates of grid points
// are then at most 2^30, within the 32-bit coordinates of Boost's builder.
constexpr int kMaxRings = 15;

struct Grid {
    double spacing;
    std::int32_t width;   // horizontal period in grid points
    std::int32_t height;  // vertical period in grid points
};

Grid grid_of(const Domain& domain) {
    const double spacing = std::max(domain.width, domain.height) / kGridPoints;
    return {spacing,
            static_cast<std::int32_t>(std::lround(domain.width / spacing)),
            static_cast<std::int32_t>(std::lround(domain.height / spacing))};
}

// A copy of a site, translated by a lattice offset.
struct SiteCopy {
    std::size_t site;
    LatticeOffset offset;
};

// The sites themselves, in their order and with offset 0; then their copies at other offsets.
struct Copies {
    std::vector<SiteCopy> copies;
    std::vector<GridPoint> points;  // position of each copy on the grid
};

void add_copy(
    Copies& all, std::size_t site, const GridPoint& p, LatticeOffset offset, const Grid& g) {
    all.copies.push_back({site, offset});
    all.points.emplace_back(p.x() + offset.i * g.width, p.y() + offset.j * g.height);
}

// Adds those copies of the sites at one offset that are within a margin around the fundamental
// cell. In this file, margins are in units of the grid spacing.
void add_copies_at(Copies& all,
                   const std::vector<GridPoint>& sites,
                   LatticeOffset offset,
                   const Grid& grid,
                   double margin) {
    const auto outside = [&](double x, double period) {
        return x < -margin || x > period + margin;
    };
    for (std::size_t k = 0; k < sites.size(); ++k) {
        const double x = sites[k].x() + static_cast<double>(offset.i) * grid.width;
        const double y = sites[k].y() + static_cast<double>(offset.j) * grid.height;
        if (!outside(x, grid.width) && !outside(y, grid.height)) {
            add_copy(all, k, sites[k], offset, grid);
        }
    }
}

// Returns the sites, then all their copies within a margin around the fundamental cell.
Copies copies_within(const std::vector<GridPoint>& sites, const Grid& grid, double margin) {
    Copies all;
    for (std::size_t k = 0; k < sites.size(); ++k) {
        add_copy(all, k, sites[k], {}, grid);
    }
    const int rings_x = std::min(kMaxRings, static_cast<int>(std::ceil(margin / grid.width)));
    const int rings_y = std::min(kMaxRings, static_cast<int>(std::ceil(margin / grid.height)));
    for (int j = -rings_y; j <= rings_y; ++j) {
        for (int i = -rings_x; i <= rings_x; ++i) {
            if (i != 0 || j != 0) {
                add_copies_at(all, sites, {i, j}, grid, margin);
            }
        }
    }
    return all;
}

// Returns the corners of one cell. Returns nothing if the cell is unbounded. Also returns nothing
// if the circle around a corner, through the sites nearest to the corner, may extend beyond the
// margin. A copy outside of the margin might then cut off a part of the cell.
std::optional<std::vector<CellCorner>> corners_of(const Diagram::cell_type& cell,
                                                  const Copies& all,
                                                  const Grid& grid,
                                                  double margin) {
    const GridPoint& site = all.points[cell.source_index()];
    std::vector<CellCorner> corners;
    const Diagram::edge_type* edge = cell.incident_edge();
    do {
        if (edge == nullptr || !edge->is_finite()) {
            return std::nullopt;
        }
        const Vec2 corner(edge->vertex0()->x(), edge->vertex0()->y());
        if (2.0 * (corner - Vec2(site.x(), site.y())).norm() > margin) {
            return std::nullopt;
        }
        const SiteCopy& across = all.copies[edge->twin()->cell()->source_index()];
        corners.push_back({corner * grid.spacing, across.site, across.offset});
        edge = edge->next();
    } while (edge != cell.incident_edge());
    return corners;
}

// Returns the cells of all sites, or nothing if the margin is too small for one of them.
std::optional<CellDiagram> cells_within(const std::vector<GridPoint>& sites,
                                        const Grid& grid,
                                        double margin) {
    const Copies all = copies_within(sites, grid, margin);
    Diagram diagram;
    boost::polygon::construct_voronoi(all.points.begin(), all.points.end(), &diagram);
    CellDiagram cells(sites.size());
    for (const Diagram::cell_type& cell : diagram.cells()) {
        if (cell.source_index() >= sites.size()) {
            continue;
        }
        std::optional<std::vector<CellCorner>> corners = corners_of(cell, all, grid, margin);
        if (!corners) {
            return std::nullopt;
        }
        cells[cell.source_index()] = std::move(*corners);
    }
    return cells;
}

// Throws std::runtime_error if a site has no cell. This happens if two sites are at the same grid
// point: the diagram then has one cell for both.
void check_every_site_has_a_cell(const CellDiagram& cells) {
    for (const std::vector<CellCorner>& cell : cells) {
        if (cell.empty()) {
            throw std::runtime_error(
                "two random sites are at the same point of the grid; try another seed");
        }
    }
}

std::string sparse_message(const Domain& domain, std::size_t sites) {
    std::ostringstream text;
    text << "the torus (" << domain.width << " x " << domain.height << ") is too long for " << sites
         << " bubbles; use more bubbles or an aspect nearer to 1";
    return text.str();
}

}  // namespace

CellDiagram voronoi_cells(const Domain& domain, const std::vector<Vec2>& sites) {
    const Grid grid = grid_of(domain);
    std::vector<GridPoint> points;
    points.reserve(sites.size());
    for (const Vec2& site : sites) {
        points.emplace_back(static_cast<std::int32_t>(std::lround(site.x() / grid.spacing)),
                            static_cast<std::int32_t>(std::lround(site.y() / grid.spacing)));
    }
    const double mean_spacing = std::sqrt(static_cast<double>(grid.width) * grid.height /
                                          static_cast<double>(sites.size()));
    const double max_margin = static_cast<double>(kMaxRings) * std::min(grid.width, grid.height);
    for (double margin = 8.0 * mean_spacing;; margin *= 2.0) {
        if (std::optional<CellDiagram> cells =
                cells_within(points, grid, std::min(margin, max_margin))) {
            check_every_site_has_a_cell(*cells);
            return std::move(*cells);
        }
        if (margin >= max_margin) {
            throw std::runtime_error(sparse_message(domain, sites.size()));
        }
    }
}

}  // namespace foam
