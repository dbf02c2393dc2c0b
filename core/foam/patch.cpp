// SPDX-License-Identifier: Apache-2.0

#include "core/foam/patch.h"

#include "core/foam/clipped_cells.h"
#include "core/foam/patch_part.h"
#include "core/foam/random.h"
#include "core/foam/spatial_order.h"
#include "core/foam/target_areas.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

// Seeds a patch from the Voronoi diagram of random points (paper section 5). The parts of the
// outline are scaled to a total area of 1 per bubble. Each part is seeded separately, with its
// share of the bubbles (prepare_parts). It is placed in the middle of a square torus, whose side is
// twice the longer side of the bounding box of the part. Random sites are drawn within the part
// and, as an option, moved by Lloyd's algorithm (Lloyd 1982, explained in seeding.cpp). Their
// Voronoi diagram on the torus is clipped to the part (clipped_cells.h). If a draw gives no valid
// foam, new sites are drawn. The cells of all parts together are converted to a foam
// (polygon_mesh.h). A part whose share is rounded to one bubble becomes a lone bubble. Outlines of
// several parts are not in the paper.

namespace foam {

namespace {

void check(std::span<const Outline> parts, const PatchOptions& options) {
    if (options.bubbles < 2) {
        throw std::invalid_argument("a patch needs at least two bubbles");
    }
    if (!(options.surface_tension > 0.0)) {
        throw std::invalid_argument("surface tension must be positive");
    }
    if (options.area_ratio != 0.0 && !(options.area_ratio >= 1.0)) {
        throw std::invalid_argument("the area ratio must be 0 or at least 1");
    }
    if (!std::ranges::all_of(parts, [](const Outline& part) { return outline_area(part) > 0.0; }) ||
        parts.empty()) {
        throw std::invalid_argument(
            "the outline has no area: it needs at least three corners that are not on one line");
    }
}

// The cells of all parts that have several bubbles, and the parts that are one bubble.
struct SeededParts {
    PolygonMesh mesh;
    std::vector<LoneBubble> lone;
    // The value of the area field at each cell and at each lone bubble; empty if there is no field.
    std::vector<double> field_of_cells;
    std::vector<double> field_of_lone;

    std::size_t count() const { return mesh.cells.size() + lone.size(); }
};

// Appends the mesh of a part, moved by a vector.
void append(PolygonMesh& mesh, const PolygonMesh& part, const Vec2& displacement) {
    const auto first = static_cast<std::uint32_t>(mesh.points.size());
    for (const Vec2& point : part.points) {
        mesh.points.push_back(point + displacement);
    }
    for (PolygonMesh::Cell cell : part.cells) {
        for (std::uint32_t& corner : cell) {
            corner += first;
        }
        mesh.cells.push_back(std::move(cell));
    }
}

// Seeds all parts. All positions are in the coordinates of the torus of the first part; the other
// parts keep their positions relative to the first part.
SeededParts seed_parts(std::span<const PreparedPart> parts,
                       const PatchOptions& options,
                       Random& random) {
    SeededParts seeded;
    for (const PreparedPart& part : parts) {
        const Vec2 displacement = parts.front().shift - part.shift;
        if (part.bubbles > 1) {
            const PartCells cells = draw_part(part, options, random);
            append(seeded.mesh, cells.mesh, displacement);
            seeded.field_of_cells.insert(
                seeded.field_of_cells.end(), cells.field.begin(), cells.field.end());
            continue;
        }
        const Vec2 center = outline_centroid(part.outline);
        seeded.lone.push_back({0, center + displacement, outline_area(part.outline)});
        if (part.areas) {
            seeded.field_of_lone.push_back(part.areas->at(center));
        }
    }
    return seeded;
}

// Moves everything so that the origin is the mean of all corners of cells and of all centers of
// lone bubbles. Scales everything to a mean area of 1.
void normalize(SeededParts& parts) {
    double area = 0.0;
    for (const PolygonMesh::Cell& cell : parts.mesh.cells) {
        area += polygon_area(parts.mesh, cell);
    }
    Vec2 sum(0.0, 0.0);
    for (const Vec2& point : parts.mesh.points) {
        sum += point;
    }
    for (const LoneBubble& bubble : parts.lone) {
        area += bubble.target_area;
        sum += bubble.center;
    }
    const double scale = std::sqrt(static_cast<double>(parts.count()) / area);
    const Vec2 middle = sum / static_cast<double>(parts.mesh.points.size() + parts.lone.size());
    for (Vec2& point : parts.mesh.points) {
        point = scale * (point - middle);
    }
    for (LoneBubble& bubble : parts.lone) {
        bubble.center = scale * (bubble.center - middle);
        bubble.target_area *= scale * scale;
    }
}

Foam foam_of(const SeededParts& parts) {
    Foam foam = valid_foam(parts.mesh);
    for (LoneBubble bubble : parts.lone) {
        bubble.identity = foam.next_identity++;
        foam.lone_bubbles.push_back(bubble);
    }
    return foam;
}

// Sets the target areas of all bubbles except the ghost, which is the last bubble of the network.
// Their mean is 1. With neither a ratio nor a field, target areas stay the areas of the cells.
void set_targets(const SeededParts& parts, double ratio, Foam& foam) {
    std::vector<double> field = parts.field_of_cells;
    field.insert(field.end(), parts.field_of_lone.begin(), parts.field_of_lone.end());
    if (field.empty() && ratio == 0.0) {
        return;
    }
    const auto in_network = static_cast<std::ptrdiff_t>(foam.network.bubble_count());
    std::vector<double> targets(foam.target_areas.begin(), foam.target_areas.begin() + in_network);
    for (const LoneBubble& bubble : foam.lone_bubbles) {
        targets.push_back(bubble.target_area);
    }
    set_target_areas(targets, field, ratio);
    scale_to_total(targets, static_cast<double>(targets.size()));
    std::copy(targets.begin(), targets.begin() + in_network, foam.target_areas.begin());
    for (std::size_t k = 0; k < foam.lone_bubbles.size(); ++k) {
        foam.lone_bubbles[k].target_area = targets[static_cast<std::size_t>(in_network) + k];
    }
}

}  // namespace

Foam seed_patch(std::span<const Outline> parts, const PatchOptions& options) {
    check(parts, options);
    Random random(options.seed);
    SeededParts seeded = seed_parts(prepare_parts(parts, options), options, random);
    normalize(seeded);
    Foam foam = foam_of(seeded);
    foam.film_tension = 2.0 * options.surface_tension;
    set_targets(seeded, options.area_ratio, foam);
    sort_if_large(foam);
    return foam;
}

Foam seed_patch(const Outline& outline, const PatchOptions& options) {
    return seed_patch(std::span(&outline, 1), options);
}

}  // namespace foam
