// SPDX-License-Identifier: Apache-2.0

#include "texgen/raster/distance/patch_regions.h"

#include "core/parallel/parallel_map.h"
#include "texgen/raster/arcs/patch_boundaries.h"
#include "texgen/raster/distance/arc_chain.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <optional>
#include <span>
#include <utility>

namespace foam::texgen {

namespace {

constexpr std::size_t kRegionsPerTask = 256;

// Converts a position from pixels to subpixels, rounded to whole numbers. The result consists of
// doubles, because it may not fit into 32 bits.
Vec2 rounded_to_subpixels(const Vec2& pixels) {
    return (kSubpixel * pixels.array() + 0.5).floor().matrix();
}

// Clamps a position in subpixels to the pixels of the image.
SubpixelPoint clamped(const Vec2& subpixels, const RasterGrid& grid) {
    const Vec2 last = Vec2(grid.width, grid.height) * kSubpixel - Vec2::Ones();
    const Vec2 within = subpixels.cwiseMax(Vec2::Zero()).cwiseMin(last);
    return {static_cast<std::int32_t>(within.x()), static_cast<std::int32_t>(within.y())};
}

// Adds to the outline the edges of a chain that approximates a side. `head` is the head of the
// side. The chain is computed from the end with the smaller x, or with the smaller y if both have
// the same x, so that both sides of a film have the same edges.
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
        boundary.add_edge(from, to, 1.0, 0.0);
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

// Returns the region of a bubble, or nullopt if the box around the region is outside the image.
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

std::vector<Region> patch_regions(const Frame& frame, const RasterGrid& grid, int threads) {
    const PixelPatch pixels{frame, grid, pixels_per_unit(grid, frame.domain)};
    const std::size_t ghost = index_of(frame.network.ghost());
    const auto make = [&](std::size_t first, std::size_t last) {
        std::vector<Region> seen;
        for (std::size_t k = first; k < last; ++k) {
            if (auto region = k == ghost ? std::nullopt : region_of(pixels, k)) {
                seen.push_back(std::move(*region));
            }
        }
        return seen;
    };
    std::vector<Region> regions;
    regions.push_back(surroundings(pixels));
    for (std::vector<Region>& seen :
         parallel_map(region_count(frame), kRegionsPerTask, threads, make)) {
        std::move(seen.begin(), seen.end(), std::back_inserter(regions));
    }
    return regions;
}

}  // namespace foam::texgen
