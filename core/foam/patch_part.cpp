// SPDX-License-Identifier: Apache-2.0

#include "core/foam/patch_part.h"

#include "core/foam/clipped_cells.h"
#include "core/foam/target_areas.h"
#include "core/foam/voronoi.h"
#include "core/network/validate.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>

// Divides the bubbles among the parts of an outline, and draws the cells of a part. Random sites
// are drawn by rejection: points outside of the part are dropped. Lloyd's algorithm moves each site
// to the centroid of its clipped cell (S. P. Lloyd, Least squares quantization in PCM, IEEE
// Transactions on Information Theory 28, 1982). An outline need not be convex, so the centroid may
// be outside; the site then stays where it is, which is our own rule. If there is an area field,
// the number of bubbles of a part is proportional to the integral of 1 / field over the part. This
// integral is approximated by a sum over the points of a grid.

namespace foam {

namespace {

constexpr int kMaxPatchDraws = 8;
// Smallest share of all bubbles that a part of the outline may have, as a number of bubbles. Cells
// smaller than the same fraction of the mean area are slivers (kSliverArea in clipped_cells.cpp).
constexpr double kMinShare = 0.1;

// For a part with b bubbles, at most kMaxPoints + kMaxPointsPerBubble * b random points are drawn.
// If fewer than b of these points are inside the part, the part is too narrow.
constexpr int kMaxPoints = 100'000;
constexpr int kMaxPointsPerBubble = 1'000;

// An area field is measured at a grid of kFieldPoints x kFieldPoints points in the bounding box of
// a part.
constexpr int kFieldPoints = 64;

Box box_of(const Outline& outline) {
    return bounding_box(std::span(&outline, 1));
}

Outline moved_and_scaled(Outline outline, const Vec2& displacement, double scale) {
    const auto apply = [&](Vec2& corner) { corner = scale * (corner + displacement); };
    std::for_each(outline.outer.begin(), outline.outer.end(), apply);
    for (std::vector<Vec2>& hole : outline.holes) {
        std::for_each(hole.begin(), hole.end(), apply);
    }
    return outline;
}

// Returns the mean over a part of 1 / a, where a is the value of the area field at a point.
double mean_density(const Outline& part, const AreaField& areas) {
    const Box box = box_of(part);
    double sum = 0.0;
    int count = 0;
    for (int y = 0; y < kFieldPoints; ++y) {
        for (int x = 0; x < kFieldPoints; ++x) {
            const Vec2 fraction = Vec2(x + 0.5, y + 0.5) / kFieldPoints;
            const Vec2 point = box.low + fraction.cwiseProduct(box.size());
            if (is_inside(part, point)) {
                sum += 1.0 / areas.at(point);
                ++count;
            }
        }
    }
    return count > 0 ? sum / count : 1.0 / areas.at(0.5 * (box.low + box.high));
}

// Returns each part's share of all bubbles, as a number of bubbles.
std::vector<double> shares_of(std::span<const Outline> parts, const PatchOptions& options) {
    const Box all = bounding_box(parts);
    std::vector<double> shares;
    for (const Outline& part : parts) {
        const double density =
            options.areas && parts.size() > 1
                ? mean_density(part, options.areas->stretched_over(all.low, all.size()))
                : 1.0;
        shares.push_back(density * outline_area(part));
    }
    scale_to_total(shares, options.bubbles);
    return shares;
}

// Prepares a part, except for its number of bubbles. `all` is the bounding box of all parts.
PreparedPart prepare(const Outline& part,
                     const Box& all,
                     double scale,
                     const std::optional<AreaField>& areas) {
    const Box box = box_of(part);
    const double side = 2.0 * scale * box.size().maxCoeff();
    const Vec2 to_middle = 0.5 * Vec2::Constant(side) / scale - 0.5 * (box.low + box.high);
    PreparedPart prepared{
        moved_and_scaled(part, to_middle, scale), {side, side}, scale * to_middle, 1, {}};
    if (areas) {
        prepared.areas = areas->stretched_over(scale * (all.low + to_middle), scale * all.size());
    }
    return prepared;
}

// Returns the error for a part whose share is below kMinShare. `position` is the middle of the
// part as a fraction of the size of the outline, from the lower left corner.
std::runtime_error too_small(const Vec2& position, double share, int bubbles) {
    const auto percent = [](double fraction) {
        return std::to_string(std::lround(100.0 * fraction));
    };
    const auto enough = static_cast<std::int64_t>(std::ceil(kMinShare / share * bubbles));
    return std::runtime_error(
        "a part of the outline, at " + percent(position.x()) + " % of its width and " +
        percent(position.y()) +
        " % of its height, is smaller than a tenth of a bubble; use at least " +
        std::to_string(enough) + " bubbles, or remove this part");
}

Vec2 random_point(const Box& box, Random& random) {
    const double x = box.low.x() + (box.high.x() - box.low.x()) * random.uniform();
    const double y = box.low.y() + (box.high.y() - box.low.y()) * random.uniform();
    return {x, y};
}

// Returns `count` random points inside the part, by drawing points and keeping those inside.
// Without an area field, points are drawn uniformly in the bounding box of the part. With an area
// field, they are drawn in the bounding box of the whole outline, where their density is
// proportional to 1 / area. Throws std::runtime_error if too few points are inside.
std::vector<Vec2> random_sites(const PreparedPart& part, int count, Random& random) {
    const Box box = box_of(part.outline);
    const std::int64_t max_points = kMaxPoints + std::int64_t{kMaxPointsPerBubble} * count;
    std::vector<Vec2> sites;
    for (std::int64_t drawn = 0; drawn < max_points; ++drawn) {
        const Vec2 site = part.areas ? part.areas->random_point(random) : random_point(box, random);
        if (is_inside(part.outline, site)) {
            sites.push_back(site);
            if (static_cast<int>(sites.size()) == count) {
                return sites;
            }
        }
    }
    throw std::runtime_error("of " + std::to_string(max_points) + " random points, only " +
                             std::to_string(sites.size()) + " are inside");
}

ClippedCells cells_of(const PreparedPart& part, const std::vector<Vec2>& sites) {
    return clip_cells(part.outline, voronoi_cells(part.domain, sites), part.areas_or_null());
}

// Draws random sites and applies Lloyd's algorithm to them. A site is not moved if the center of
// its cell is outside of the outline. Returns the clipped cells of the final sites.
ClippedCells draw_cells(const PreparedPart& prepared, const PatchOptions& options, Random& random) {
    std::vector<Vec2> sites = random_sites(prepared, prepared.bubbles, random);
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

// Returns the value of the area field at each cell of the mesh (AreaField::mean_over). Returns an
// empty list if there is no field.
std::vector<double> field_areas(const PreparedPart& part, const PolygonMesh& mesh) {
    std::vector<double> areas;
    for (std::size_t cell = 0; part.areas && cell < mesh.cells.size(); ++cell) {
        areas.push_back(part.areas->mean_over(polygon_of(mesh, mesh.cells[cell])));
    }
    return areas;
}

std::string no_patch_message(int bubbles, const std::string& cause) {
    return "no valid patch of " + std::to_string(bubbles) +
           " bubbles fits into this outline: it is too narrow, or has parts too small for a "
           "bubble; use more bubbles or a wider outline (" +
           cause + ")";
}

}  // namespace

std::vector<PreparedPart> prepare_parts(std::span<const Outline> parts,
                                        const PatchOptions& options) {
    const Box all = bounding_box(parts);
    double area = 0.0;
    for (const Outline& part : parts) {
        area += outline_area(part);
    }
    const double scale = std::sqrt(options.bubbles / area);
    const std::vector<double> shares = shares_of(parts, options);
    std::vector<PreparedPart> prepared;
    for (std::size_t k = 0; k < parts.size(); ++k) {
        if (shares[k] < kMinShare) {
            const Box box = box_of(parts[k]);
            const Vec2 middle = 0.5 * (box.low + box.high) - all.low;
            throw too_small(middle.cwiseQuotient(all.size()), shares[k], options.bubbles);
        }
        prepared.push_back(prepare(parts[k], all, scale, options.areas));
        prepared.back().bubbles = std::max(1, static_cast<int>(std::lround(shares[k])));
    }
    return prepared;
}

Foam valid_foam(const PolygonMesh& mesh) {
    Foam foam = foam_from_mesh(mesh);
    if (const auto fault = find_fault(foam.network)) {
        throw std::runtime_error(*fault);
    }
    return foam;
}

PartCells draw_part(const PreparedPart& part, const PatchOptions& options, Random& random) {
    for (int draw = 1;; ++draw) {
        try {
            PolygonMesh mesh = draw_cells(part, options, random).mesh;
            merge_slivers(mesh, part.areas_or_null());
            valid_foam(mesh);
            std::vector<double> field = field_areas(part, mesh);
            return {std::move(mesh), std::move(field)};
        } catch (const std::runtime_error& error) {
            if (draw == kMaxPatchDraws) {
                throw std::runtime_error(no_patch_message(part.bubbles, error.what()));
            }
        }
    }
}

}  // namespace foam
