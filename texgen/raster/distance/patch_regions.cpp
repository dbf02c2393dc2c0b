#include "texgen/raster/distance/patch_regions.h"

#include "core/parallel/parallel_map.h"
#include "texgen/raster/distance/arc_chain.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <utility>

namespace foam::texgen {

namespace {

constexpr std::size_t kRegionsPerTask = 256;

// Rounds a position in pixels to subpixels, which may not fit 32 bits.
Vec2 rounded_to_subpixels(const Vec2& pixels) {
    return (kSubpixel * pixels.array() + 0.5).floor().matrix();
}

SubpixelPoint clamped(const Vec2& subpixels, const RasterGrid& grid) {
    const Vec2 last = Vec2(grid.width, grid.height) * kSubpixel - Vec2::Ones();
    const Vec2 within = subpixels.cwiseMax(Vec2::Zero()).cwiseMin(last);
    return {static_cast<std::int32_t>(within.x()), static_cast<std::int32_t>(within.y())};
}

// Appends the edges of a chain that stands for a side. Both sides of a film have the same ones.
void append_edges(const ArcLoops::Side& side,
                  const Vec2& head,
                  const Vec2& offset,
                  std::vector<Edge>& edges) {
    const bool tail_first = std::pair(side.tail.x(), side.tail.y()) < std::pair(head.x(), head.y());
    std::vector<Vec2> points;
    append_inner_points(film_arc(tail_first ? side.arc : reversed(side.arc)),
                        tail_first ? side.tail : head,
                        points);
    if (!tail_first) {
        std::reverse(points.begin(), points.end());
    }
    points.push_back(head);
    Vec2 from = rounded_to_subpixels(side.tail) + offset;
    for (const Vec2& point : points) {
        const Vec2 to = rounded_to_subpixels(point) + offset;
        edges.push_back({from, to});
        from = to;
    }
}

}  // namespace

PatchRegions::PatchRegions(const Frame& frame, const RasterGrid& grid, int threads)
    : pixels_{frame, grid, pixels_per_unit(grid, frame.domain)},
      around_(boundaries_of(pixels_, frame.network.ghost())) {
    const std::size_t ghost = index_of(frame.network.ghost());
    const auto make = [&](std::size_t first, std::size_t last) {
        Boundary boundary;
        std::vector<Region> seen;
        for (std::size_t k = first; k < last; ++k) {
            const auto id = static_cast<std::uint32_t>(k);
            if (const auto region = k == ghost ? std::nullopt : region_of(id, boundary)) {
                seen.push_back(*region);
            }
        }
        return seen;
    };
    const SubpixelPoint last = clamped(Vec2::Constant(std::numeric_limits<double>::max()), grid);
    regions_.push_back({static_cast<std::uint32_t>(ghost), RegionKind::Surroundings, {}, {}, last});
    const std::size_t count = region_count(frame);
    for (const std::vector<Region>& seen : parallel_map(count, kRegionsPerTask, threads, make)) {
        regions_.insert(regions_.end(), seen.begin(), seen.end());
    }
}

// Returns nothing for a region that is outside of the image.
std::optional<Region> PatchRegions::region_of(std::uint32_t id, Boundary& boundary) const {
    boundary.clear();
    append_boundary(id, {}, boundary);
    const Extent extent = extent_of(boundary);
    const Vec2 size = Vec2(grid().width, grid().height) * kSubpixel;
    if ((extent.highest.array() < 0.0).any() || (extent.lowest.array() >= size.array()).any()) {
        return std::nullopt;
    }
    const bool is_lone = id >= pixels_.frame.network.bubble_slots();
    return Region{id,
                  is_lone ? RegionKind::Circle : RegionKind::Bubble,
                  {},
                  clamped(extent.lowest, grid()),
                  clamped(extent.highest, grid())};
}

void PatchRegions::append_boundary(std::uint32_t id,
                                   SubpixelPoint offset,
                                   Boundary& boundary) const {
    const auto bubble = id_at<BubbleId>(id);
    const bool is_around = bubble == pixels_.frame.network.ghost();
    const ArcLoops traced = is_around ? around_ : boundaries_of(pixels_, bubble);
    const Vec2 by(offset.x, offset.y);
    for (std::size_t loop = 0; loop < traced.loop_ends.size(); ++loop) {
        const std::span<const ArcLoops::Side> sides = traced.loop(loop);
        for (std::size_t k = 0; k < sides.size(); ++k) {
            const Vec2& head = sides[(k + 1) % sides.size()].tail;
            boundary.sides.push_back({sides[k].arc,
                                      sides[k].tail + by / kSubpixel,
                                      rounded_to_subpixels(sides[k].tail) + by,
                                      rounded_to_subpixels(head) + by});
            append_edges(sides[k], head, by, boundary.edges);
        }
        boundary.close_loop();
    }
}

}  // namespace foam::texgen
