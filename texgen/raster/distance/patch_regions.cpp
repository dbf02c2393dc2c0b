// SPDX-License-Identifier: Apache-2.0

#include "texgen/raster/distance/patch_regions.h"

#include "core/geometry/elementary.h"
#include "core/parallel/parallel_map.h"
#include "texgen/raster/arcs/patch_boundaries.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <optional>
#include <span>
#include <utility>

// In a patch, chains of straight edges decide the ids of pixels. Where an edge crosses the middle
// of a row, the crossing is rounded up to a whole subpixel. The centers of pixels are at whole
// subpixels, so the same pixels are on the right of the rounded crossing as of the exact one
// (PixelMask::flip_right_of). The inner points of a chain are moved off the arc so that the chain
// encloses nearly the same area as the arc. For this, a circular segment counts as a segment of a
// parabola, whose area is 2/3 of its width times its height (Archimedes, "Quadrature of the
// Parabola"). Distances are measured from the arcs themselves. The method is our own.

namespace foam::texgen {

namespace {

constexpr std::size_t kRegionsPerTask = 256;

// Limits for the edges of a chain (append_chain_points). The sagitta of an edge is the largest
// distance of the edge from the part of the arc that it replaces. Edges that end on the arc would
// cut off area. The inner points of the chain are therefore moved outwards, away from the center of
// the circle, to add the same area. Within a pixel that contains whole edges, the two areas cancel,
// so short edges may have a larger sagitta. Longer edges must be accurate on their own.
//
// An arc whose sagitta is at most kSagitta is replaced by its chord. Any other arc is divided into
// one edge more than the limits require. If the limits require only one edge, the chain then still
// has an inner point that can add area. The ends of the arc cannot be moved for this. All lengths
// are in pixels.
constexpr double kSagittaOfShortEdges = 1.0 / 256;  // largest sagitta of short edges
constexpr double kShortEdge = std::numbers::sqrt2;  // largest length of short edges
constexpr double kSagitta = 1.0 / 1024;             // largest sagitta of longer edges

// A rotation to the left by an angle, stored as its cosine and sine.
struct Rotation {
    double c;
    double s;

    Rotation(double cosine, double sine) : c(cosine), s(sine) {}
    explicit Rotation(double angle) : Rotation(ieee::sincos(angle)) {}
    explicit Rotation(const ieee::SineAndCosine& angle) : Rotation(angle.cosine, angle.sine) {}

    // Returns the rotation by twice the angle.
    Rotation twice() const { return {c * c - s * s, 2.0 * c * s}; }
    Vec2 operator*(const Vec2& v) const { return {c * v.x() - s * v.y(), s * v.x() + c * v.y()}; }
    // Returns v rotated in the opposite direction.
    Vec2 back(const Vec2& v) const { return {c * v.x() + s * v.y(), c * v.y() - s * v.x()}; }
};

// Returns the number of edges of a chain. `sine` is the sine of the half angle. An arc of length l
// and half angle a has a sagitta of at most l a / 4. Each of n equal parts has the length l / n and
// the half angle a / n. The sagitta of a part is therefore smaller by a factor of n².
int edge_count(const FilmArc& arc, double sine) {
    const double turn = std::abs(arc.half_angle);
    const double length = arc.chord.norm() * turn / std::abs(sine);  // NaN for a straight arc
    const double sagitta = 0.25 * length * turn;
    if (!(sagitta > kSagitta)) {  // true for NaN, too
        return 1;
    }
    const double coarse = std::max(std::sqrt(sagitta / kSagittaOfShortEdges), length / kShortEdge);
    return 1 + static_cast<int>(std::ceil(std::min(coarse, std::sqrt(sagitta / kSagitta))));
}

// Clamps a position in subpixels to the pixels of the image.
SubpixelPoint clamped(const Vec2& subpixels, const RasterGrid& grid) {
    const Vec2 last = Vec2(grid.width, grid.height) * kSubpixel - Vec2::Ones();
    const Vec2 within = subpixels.cwiseMax(Vec2::Zero()).cwiseMin(last);
    return {static_cast<std::int32_t>(within.x()), static_cast<std::int32_t>(within.y())};
}

// Adds to the outline the edges of a chain that approximates a side with the given head. The chain
// is computed from the end with the smaller x, or with the smaller y if both have the same x. Both
// sides of a film therefore have the same edges.
void add_chain(const ArcLoops::Side& side, const Vec2& head, Boundary& boundary) {
    const bool tail_first = std::pair(side.tail.x(), side.tail.y()) < std::pair(head.x(), head.y());
    std::vector<Vec2> points;
    append_chain_points(film_arc(tail_first ? side.arc : reversed(side.arc)),
                        tail_first ? side.tail : head,
                        points);
    if (!tail_first) {
        std::reverse(points.begin(), points.end());
    }
    points.push_back(head);
    Vec2 from = rounded_to_subpixels(side.tail);
    for (const Vec2& point : points) {
        const Vec2 to = rounded_to_subpixels(point);
        boundary.add_edge({from, to});
        from = to;
    }
}

// Returns the boundary of a region: its exact arcs, and their chains as the outline.
Boundary boundary_of(const PixelPatch& pixels, BubbleId bubble) {
    const ArcLoops traced = boundaries_of(pixels, bubble);
    Boundary boundary;
    for (std::size_t loop = 0; loop < traced.loop_ends.size(); ++loop) {
        const std::span<const ArcLoops::Side> sides = traced.loop(loop);
        for (std::size_t k = 0; k < sides.size(); ++k) {
            boundary.add_arc(sides[k].arc, sides[k].tail);
            add_chain(sides[k], sides[(k + 1) % sides.size()].tail, boundary);
        }
        boundary.close_loop();
    }
    return boundary;
}

// Returns the region of a bubble or lone bubble, or nullopt if the box around it is outside the
// image.
std::optional<Region> region_of(const PixelPatch& pixels, std::size_t index) {
    const RasterGrid& grid = pixels.grid;
    Region region;
    region.boundary = boundary_of(pixels, id_at<BubbleId>(index));
    const Extent extent = region.boundary.extent();
    const Vec2 size = Vec2(grid.width, grid.height) * kSubpixel;
    if ((extent.highest.array() < 0.0).any() || (extent.lowest.array() >= size.array()).any()) {
        return std::nullopt;
    }
    const bool is_lone = index >= pixels.frame.network.bubble_slots();
    region.id = static_cast<std::uint32_t>(index);
    region.kind = is_lone ? RegionKind::Circle : RegionKind::Bubble;
    region.is_chain = true;
    region.lowest = clamped(extent.lowest, grid);
    region.highest = clamped(extent.highest, grid);
    return region;
}

// Returns the region of the ghost bubble. Its box is the whole image.
Region surroundings(const PixelPatch& pixels) {
    const BubbleId ghost = pixels.frame.network.ghost();
    Region region;
    region.id = static_cast<std::uint32_t>(index_of(ghost));
    region.kind = RegionKind::Surroundings;
    region.is_chain = true;
    region.highest = clamped(Vec2::Constant(std::numeric_limits<double>::max()), pixels.grid);
    region.boundary = boundary_of(pixels, ghost);
    return region;
}

}  // namespace

// The n edges, each of length e, cut off n circular segments, each with an area of about
// 2/3 sagitta * e. Moving an inner point outwards by a distance adds an area of about distance * e,
// and there are n - 1 inner points. The total areas that are cut off and added are equal for
// distance = 2/3 sagitta * n / (n - 1). The outward direction is normal to the sum of the two edge
// vectors at the point. The length of this sum is 2 cos(half_step) times the length of an edge.
void append_chain_points(const FilmArc& arc, const Vec2& tail, std::vector<Vec2>& points) {
    const Rotation half_turn(arc.half_angle);
    const int edges = edge_count(arc, half_turn.s);
    if (edges == 1) {
        return;
    }
    const Rotation half_step(arc.half_angle / edges);
    const Rotation step = half_step.twice();
    Vec2 edge = half_step * half_turn.back(arc.chord) * (half_step.s / half_turn.s);
    // `sagitta` is in units of the length of an edge, `outwards` in units of the length of the sum
    // of two successive edges. Both are negative if the arc turns right.
    const double sagitta = 0.5 * half_step.s / (1.0 + half_step.c);
    const double outwards = 2.0 / 3.0 * sagitta * edges / (edges - 1) / (2.0 * half_step.c);
    Vec2 at = tail;
    for (int k = 1; k < edges; ++k) {
        const Vec2 next_edge = step * edge;
        at += edge;
        points.emplace_back(at - outwards * turned_left(edge + next_edge));
        edge = next_edge;
    }
}

std::vector<Region> patch_regions(const Frame& frame, const RasterGrid& grid, int threads) {
    const PixelPatch pixels{frame, grid, pixels_per_unit(grid, frame.domain)};
    const std::size_t ghost = index_of(frame.network.ghost());
    const auto make = [&](std::size_t first, std::size_t last) {
        std::vector<Region> visible;
        for (std::size_t k = first; k < last; ++k) {
            if (auto region = k == ghost ? std::nullopt : region_of(pixels, k)) {
                visible.push_back(std::move(*region));
            }
        }
        return visible;
    };
    std::vector<Region> regions;
    regions.push_back(surroundings(pixels));
    for (std::vector<Region>& visible :
         parallel_map(region_count(frame), kRegionsPerTask, threads, make)) {
        std::move(visible.begin(), visible.end(), std::back_inserter(regions));
    }
    return regions;
}

}  // namespace foam::texgen
