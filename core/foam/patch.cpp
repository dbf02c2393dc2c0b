// SPDX-License-Identifier: Apache-2.0

#include "core/foam/patch.h"

#include "core/foam/clipped_cells.h"
#include "core/foam/random.h"
#include "core/foam/target_areas.h"
#include "core/foam/voronoi.h"
#include "core/network/validate.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

// Seeds a patch from the Voronoi diagram of random points (paper section 5). The outline is scaled
// to an area of 1 per bubble and placed in the middle of a square torus, whose side is twice the
// longer side of the bounding box of the outline. Random sites are drawn within the outline and, as
// an option, moved by Lloyd's algorithm (seeding.cpp). Their Voronoi diagram on the torus is
// clipped to the outline (clipped_cells.h) and converted to a foam (polygon_mesh.h). If a draw
// gives no valid foam, new sites are drawn.

namespace foam {

namespace {

constexpr int kMaxPatchDraws = 8;

void check(const Outline& outline, const PatchOptions& options) {
    if (options.bubbles < 2) {
        throw std::invalid_argument("a patch needs at least two bubbles");
    }
    if (!(options.surface_tension > 0.0)) {
        throw std::invalid_argument("surface tension must be positive");
    }
    if (options.area_ratio != 0.0 && !(options.area_ratio >= 1.0)) {
        throw std::invalid_argument("the area ratio must be 0 or at least 1");
    }
    if (!(outline_area(outline) > 0.0)) {
        throw std::invalid_argument(
            "the outline has no area: it needs at least three corners that are not on one line");
    }
}

struct Box {
    Vec2 low;
    Vec2 high;
};

Box box_of(const Outline& outline) {
    Box box{outline.outer.front(), outline.outer.front()};
    for (const Vec2& corner : outline.outer) {
        box.low = box.low.cwiseMin(corner);
        box.high = box.high.cwiseMax(corner);
    }
    return box;
}

Outline moved_and_scaled(Outline outline, const Vec2& by, double scale) {
    const auto apply = [&](Vec2& corner) { corner = scale * (corner + by); };
    std::for_each(outline.outer.begin(), outline.outer.end(), apply);
    for (std::vector<Vec2>& hole : outline.holes) {
        std::for_each(hole.begin(), hole.end(), apply);
    }
    return outline;
}

// The outline, scaled to an area of 1 per bubble, in the middle of the torus. Within the outline,
// the lattice copies of sites do not affect the cells: because the torus is at least twice as wide
// and at least twice as high as the outline, a copy of a site is never nearer to a point within
// the outline than the site itself.
struct PreparedOutline {
    Outline outline;
    Domain domain;
    std::optional<AreaField> areas;  // stretched over the bounding box of the outline

    const AreaField* areas_or_null() const { return areas ? &*areas : nullptr; }
};

PreparedOutline prepare(const Outline& outline, const PatchOptions& options) {
    const Box box = box_of(outline);
    const Vec2 size = box.high - box.low;
    const double scale = std::sqrt(options.bubbles / outline_area(outline));
    const double side = 2.0 * scale * size.maxCoeff();
    const Vec2 to_middle = 0.5 * Vec2::Constant(side) / scale - 0.5 * (box.low + box.high);
    PreparedOutline prepared{moved_and_scaled(outline, to_middle, scale), {side, side}, {}};
    if (options.areas) {
        prepared.areas = options.areas->stretched_over(scale * (box.low + to_middle), scale * size);
    }
    return prepared;
}

Vec2 random_point(const Box& box, Random& random) {
    const double x = box.low.x() + (box.high.x() - box.low.x()) * random.uniform();
    const double y = box.low.y() + (box.high.y() - box.low.y()) * random.uniform();
    return {x, y};
}

// Returns `count` random points inside the outline. Draws points in its bounding box, uniformly or
// with the density of the area field, and keeps the points inside the outline.
std::vector<Vec2> random_sites(const PreparedOutline& prepared, int count, Random& random) {
    const Box box = box_of(prepared.outline);
    std::vector<Vec2> sites;
    while (static_cast<int>(sites.size()) < count) {
        const Vec2 site =
            prepared.areas ? prepared.areas->random_point(random) : random_point(box, random);
        if (is_inside(prepared.outline, site)) {
            sites.push_back(site);
        }
    }
    return sites;
}

ClippedCells cells_of(const PreparedOutline& prepared, const std::vector<Vec2>& sites) {
    return clip_cells(
        prepared.outline, voronoi_cells(prepared.domain, sites), prepared.areas_or_null());
}

// Draws random sites and applies Lloyd's algorithm to them. A site is not moved if the center of
// its cell is outside of the outline. Returns the clipped cells of the final sites.
ClippedCells draw_cells(const PreparedOutline& prepared,
                        const PatchOptions& options,
                        Random& random) {
    std::vector<Vec2> sites = random_sites(prepared, options.bubbles, random);
    ClippedCells cells = cells_of(prepared, sites);
    for (int k = 0; k < options.lloyd_iterations; ++k) {
        for (std::size_t cell = 0; cell < sites.size(); ++cell) {
            const Vec2 center = cells.centers[cell];
            sites[cell] = is_inside(prepared.outline, center) ? center : sites[cell];
        }
        cells = cells_of(prepared, sites);
    }
    return cells;
}

// Moves the mean of the points to the origin and scales the mesh to a mean cell area of 1.
void normalize(PolygonMesh& mesh) {
    double area = 0.0;
    for (const PolygonMesh::Cell& cell : mesh.cells) {
        area += polygon_area(mesh, cell);
    }
    const double scale = std::sqrt(static_cast<double>(mesh.cells.size()) / area);
    const Vec2 middle = std::accumulate(mesh.points.begin(), mesh.points.end(), Vec2(0.0, 0.0)) /
                        static_cast<double>(mesh.points.size());
    for (Vec2& point : mesh.points) {
        point = scale * (point - middle);
    }
}

// Returns the area of the area field at each cell of the mesh; empty if there is no field.
std::vector<double> field_areas(const PreparedOutline& prepared, const PolygonMesh& mesh) {
    std::vector<double> areas;
    for (std::size_t cell = 0; prepared.areas && cell < mesh.cells.size(); ++cell) {
        areas.push_back(prepared.areas->mean_over(polygon_of(mesh, mesh.cells[cell])));
    }
    return areas;
}

// Sets the target areas of all bubbles except the ghost, which is the last bubble. Their mean is 1.
// `field` has the area of the area field at each cell, or is empty.
void set_targets(std::span<const double> field, double ratio, Foam& foam) {
    const std::span<double> targets(foam.target_areas.begin(), foam.network.bubble_count());
    set_target_areas(targets, field, ratio);
    if (!field.empty() || ratio > 0.0) {
        scale_to_total(targets, static_cast<double>(targets.size()));
    }
}

// Merges slivers (clipped_cells.h), normalizes the mesh and returns it as a foam. Throws
// std::runtime_error if the foam is not valid.
Foam foam_of(const PreparedOutline& prepared, ClippedCells cells, double area_ratio) {
    merge_slivers(cells.mesh, prepared.areas_or_null());
    const std::vector<double> field = field_areas(prepared, cells.mesh);
    normalize(cells.mesh);
    Foam foam = foam_from_mesh(cells.mesh);
    if (const auto fault = find_fault(foam.network)) {
        throw std::runtime_error(*fault);
    }
    set_targets(field, area_ratio, foam);
    return foam;
}

std::string no_patch_message(int bubbles, const std::string& cause) {
    return "no valid patch of " + std::to_string(bubbles) +
           " bubbles fits into this outline: it is too narrow, or has parts too small for a "
           "bubble; use more bubbles or a wider outline (" +
           cause + ")";
}

}  // namespace

Foam seed_patch(const Outline& outline, const PatchOptions& options) {
    check(outline, options);
    Random random(options.seed);
    const PreparedOutline prepared = prepare(outline, options);
    for (int draw = 1;; ++draw) {
        try {
            Foam foam =
                foam_of(prepared, draw_cells(prepared, options, random), options.area_ratio);
            foam.film_tension = 2.0 * options.surface_tension;
            return foam;
        } catch (const std::runtime_error& error) {
            if (draw == kMaxPatchDraws) {
                throw std::runtime_error(no_patch_message(options.bubbles, error.what()));
            }
        }
    }
}

}  // namespace foam
