#include "texgen/raster/distance/frame_regions.h"

#include <algorithm>
#include <cstddef>

namespace foam::texgen {

namespace {

using Source = std::variant<TorusRegions, PatchRegions>;

Source source_of(const Frame& frame, const RasterGrid& grid, int threads) {
    if (frame.domain.is_plane()) {
        return Source(std::in_place_type<PatchRegions>, frame, grid, threads);
    }
    return Source(std::in_place_type<TorusRegions>, frame, grid, threads);
}

}  // namespace

FrameRegions::FrameRegions(const Frame& frame, const RasterGrid& grid, int threads)
    : grid_(grid), source_(source_of(frame, grid_, threads)) {}

std::span<const Region> FrameRegions::regions() const {
    return std::visit([](const auto& source) { return std::span(source.regions()); }, source_);
}

void FrameRegions::trace(std::uint32_t region, SubpixelPoint offset, Boundary& boundary) const {
    boundary.clear();
    std::visit([&](const auto& source) { source.trace(region, offset, boundary); }, source_);
}

Buckets<RegionCopy> FrameRegions::copies_by_band(int rows_per_band, int threads) const {
    constexpr std::size_t kRegionsPerPart = 4096;
    const auto bands = static_cast<std::size_t>((grid_.height - 1) / rows_per_band) + 1;
    const std::span<const Region> all = regions();
    const std::size_t parts = (all.size() + kRegionsPerPart - 1) / kRegionsPerPart;
    return counting_sort<RegionCopy>(bands, parts, threads, [&](std::size_t part, const auto& put) {
        const std::size_t end = std::min((part + 1) * kRegionsPerPart, all.size());
        for (std::size_t k = part * kRegionsPerPart; k < end; ++k) {
            put_copies(static_cast<std::uint32_t>(k), rows_per_band, put);
        }
    });
}

// Calls put(band, copy) for the copies of a region and the bands of rows that they reach into.
template <class Put>
void FrameRegions::put_copies(std::uint32_t region, int rows_per_band, const Put& put) const {
    for_each_copy(region, [&](const RegionCopy& copy) {
        const PixelBox box = box_around(regions()[region], copy.translation);
        const int last = std::min(box.top, grid_.height) - 1;
        for (int band = std::max(box.bottom, 0) / rows_per_band;
             band <= last / rows_per_band && last >= 0;
             ++band) {
            put(static_cast<std::size_t>(band), copy);
        }
    });
}

// Copies around the torus are moved by whole periods so that the first point is within the columns
// of the image. A copy one period up is moved to the right by the shear.
template <class Visit>
void FrameRegions::for_each_copy(std::uint32_t region, const Visit& visit) const {
    const auto* torus = std::get_if<TorusRegions>(&source_);
    if (torus == nullptr) {
        visit(RegionCopy{region, {}});
        return;
    }
    const Region& of = regions()[region];
    const SubpixelPoint shift = shift_of(grid_);
    const std::int32_t width = grid_.width * kSubpixel;
    const std::int32_t height = grid_.height * kSubpixel;
    const std::int32_t high = of.highest.y + shift.y;
    for (std::int32_t up = floor_div(of.lowest.y + shift.y, height); up * height <= high; ++up) {
        const std::int32_t x = shift.x - up * torus->shear();
        const std::int32_t columns = floor_div(of.first.x + x, width) * width;
        visit(RegionCopy{region, {x - columns, shift.y - up * height}});
    }
}

void RegionPixels::place(const FrameRegions& regions, const RegionCopy& copy, PixelRows rows) {
    region_ = regions.regions()[copy.region];
    box_ = box_around(region_, copy.translation);
    regions.trace(copy.region, copy.translation - box_.corner(), boundary_);
    const PixelRows shown{std::max(rows.begin - box_.bottom, 0),
                          std::min(rows.end, box_.top) - box_.bottom};
    mask_.reset(box_.columns(), shown, region_.kind == RegionKind::Surroundings);
    for (const Edge& edge : boundary_.edges) {
        mask_.flip_right_of(edge);
    }
    for (std::size_t k = 0; boundary_.edges.empty() && k < boundary_.sides.size(); ++k) {
        mask_.flip_right_of(boundary_.sides[k]);
    }
}

}  // namespace foam::texgen
