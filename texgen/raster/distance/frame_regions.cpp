// SPDX-License-Identifier: Apache-2.0

#include "texgen/raster/distance/frame_regions.h"

#include "core/parallel/counting_sort.h"
#include "core/parallel/parallel_for.h"
#include "texgen/raster/distance/patch_regions.h"
#include "texgen/raster/distance/torus_regions.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace foam::texgen {

namespace {

// On a torus, a bubble that is within one band of rows of the unshifted grid is painted immediately
// after it is traced, so that its boundary is not stored. Bands are painted in parallel. All other
// regions, and all regions of a patch, are stored and sorted by the bands of the image that they
// overlap. They are then painted band by band, each band on one thread. No two threads write the
// same rows, and the order in which overlapping regions are painted depends neither on threads nor
// on shifts.

// The number of rows of a band, a multiple of RegionField::kTileRows and TorusRegions::kSquare.
constexpr int kBandRows = 128;

// A copy of a region that overlaps the image.
struct RegionCopy {
    const Region* region = nullptr;
    SubpixelPoint translation;  // from the region to its copy
};

int bands_of(const RasterGrid& grid) {
    return (grid.height - 1) / kBandRows + 1;
}

PixelRows band_rows(const RasterGrid& grid, int band) {
    return {band * kBandRows, std::min((band + 1) * kBandRows, grid.height)};
}

// Calls visit(translation) for the copies of a region that overlap the rows of an image. In the
// plane, the only copy is the region itself. On a torus, copies are moved by whole periods so that
// Region::first is within the columns of the image. The copies further left and right are left out,
// because painting wraps columns around. A copy one period up is also moved to the right by `shear`
// subpixels.
template <class Visit>
void for_each_copy(const Region& of,
                   const RasterGrid& grid,
                   std::int32_t shear,
                   const Visit& visit) {
    if (grid.view) {
        visit(SubpixelPoint{});
        return;
    }
    const SubpixelPoint shift = shift_of(grid);
    const std::int32_t width = grid.width * kSubpixel;
    const std::int32_t height = grid.height * kSubpixel;
    const std::int32_t high = of.highest.y + shift.y;
    for (std::int32_t up = floor_div(of.lowest.y + shift.y, height); up * height <= high; ++up) {
        const std::int32_t x = shift.x - up * shear;
        const std::int32_t columns = floor_div(of.first.x + x, width) * width;
        visit(SubpixelPoint{x - columns, shift.y - up * height});
    }
}

// Calls put(band, copy) for each copy of a region and each band of the image that the copy
// overlaps.
template <class Put>
void put_copies(const Region& region, const RasterGrid& grid, std::int32_t shear, const Put& put) {
    for_each_copy(region, grid, shear, [&](SubpixelPoint translation) {
        const PixelBox box = box_around(region, translation);
        const int rows = std::min(box.top, grid.height);
        for (int band = std::max(box.bottom, 0) / kBandRows; band * kBandRows < rows; ++band) {
            put(static_cast<std::size_t>(band), {&region, translation});
        }
    });
}

// Returns the copies of all regions, with one bucket per band of the image. Within a bucket, copies
// are in the order of their regions.
Buckets<RegionCopy> copies_by_band(std::span<const Region> regions,
                                   const RasterGrid& grid,
                                   std::int32_t shear,
                                   int threads) {
    constexpr std::size_t kRegionsPerPart = 4096;
    const auto bands = static_cast<std::size_t>(bands_of(grid));
    const std::size_t parts = (regions.size() + kRegionsPerPart - 1) / kRegionsPerPart;
    return counting_sort<RegionCopy>(bands, parts, threads, [&](std::size_t part, const auto& put) {
        const std::size_t end = std::min((part + 1) * kRegionsPerPart, regions.size());
        for (std::size_t k = part * kRegionsPerPart; k < end; ++k) {
            put_copies(regions[k], grid, shear, put);
        }
    });
}

// Traces the bubbles of a torus that begin (torus_regions.h) in a band of rows of the unshifted
// grid. Bubbles that are within the band are painted immediately. No other worker paints the same
// rows, because a shift of the grid moves all bands by the same distance. The other bubbles are
// appended to `rest`.
class TorusPainter {
  public:
    TorusPainter(const TorusRegions& regions,
                 const RasterGrid& grid,
                 int worker,
                 const PaintRegion& paint)
        : grid_(grid), worker_(worker), regions_(regions), paint_(paint) {}

    void paint(int band, std::vector<Region>& rest) {
        std::span<const TorusRegions::Start> starts = regions_.starts(band * kBandRows, kBandRows);
        while (!starts.empty()) {
            const std::size_t count = std::min(starts.size(), group_.size());
            regions_.trace(starts.first(count), group_);
            starts = starts.subspan(count);
            for (const Region& region : std::span(group_).first(count)) {
                if (is_within(region, band)) {
                    paint(region);
                } else {
                    rest.push_back(region);
                }
            }
        }
    }

  private:
    // Returns true if a region is within a band. A region that begins on the upper border of the
    // grid belongs to the first band, which contains its periodic copy.
    bool is_within(const Region& region, int band) const {
        const std::int32_t height = grid_.height * kSubpixel;
        const std::int32_t down = region.first.y < height ? 0 : height;
        return box_around(region, {0, -down}).is_within(band_rows(grid_, band));
    }

    void paint(const Region& region) const {
        for_each_copy(region, grid_, regions_.shear(), [&](SubpixelPoint translation) {
            paint_(worker_, region, translation, {0, grid_.height});
        });
    }

    const RasterGrid& grid_;
    int worker_;
    const TorusRegions& regions_;
    const PaintRegion& paint_;
    std::array<Region, TorusRegions::kGroupSize> group_;
};

// Paints the bubbles that are within one band, and returns the regions of all others.
std::vector<Region> paint_within_bands(const TorusRegions& regions,
                                       const RasterGrid& grid,
                                       int workers,
                                       const PaintRegion& paint) {
    std::vector<TorusPainter> painters;
    painters.reserve(static_cast<std::size_t>(workers));
    for (int worker = 0; worker < workers; ++worker) {
        painters.emplace_back(regions, grid, worker, paint);
    }
    std::vector<std::vector<Region>> rest(static_cast<std::size_t>(bands_of(grid)));
    parallel_for(bands_of(grid), painters, [&](TorusPainter& own, int band) {
        own.paint(band, rest[static_cast<std::size_t>(band)]);
    });
    std::vector<Region> all;
    for (std::vector<Region>& of_band : rest) {
        std::move(of_band.begin(), of_band.end(), std::back_inserter(all));
    }
    return all;
}

}  // namespace

// A stored region that overlaps several bands is painted in one part per band, so that no two
// threads write the same rows.
void paint_regions(const Frame& frame,
                   const RasterGrid& grid,
                   int workers,
                   const PaintRegion& paint) {
    std::int32_t shear = 0;
    std::vector<Region> rest;
    if (frame.domain.is_plane()) {
        rest = patch_regions(frame, grid, workers);
    } else {
        const TorusRegions regions(frame, grid, workers);
        shear = regions.shear();
        rest = paint_within_bands(regions, grid, workers, paint);
    }
    const Buckets<RegionCopy> copies = copies_by_band(rest, grid, shear, workers);
    std::vector<int> all(static_cast<std::size_t>(workers));
    std::iota(all.begin(), all.end(), 0);
    parallel_for(bands_of(grid), all, [&](int worker, int band) {
        const auto k = static_cast<std::size_t>(band);
        for (const RegionCopy& copy : copies.items_of(k, k + 1)) {
            paint(worker, *copy.region, copy.translation, band_rows(grid, band));
        }
    });
}

void RegionPixels::rasterize(const Region& region, SubpixelPoint translation, PixelRows rows) {
    box_ = box_around(region, translation);
    const SubpixelPoint by = translation - box_.corner();
    const PixelRows shown{std::max(rows.begin - box_.bottom, 0),
                          std::min(rows.end, box_.top) - box_.bottom};
    const Vec2 subpixels(by.x, by.y);
    offset_ = subpixels / kSubpixel;
    mask_.reset(box_.columns(), shown, region.kind == RegionKind::Surroundings);
    mask_.flip_right_of(region.boundary.outline(), subpixels, region.is_chain);
}

}  // namespace foam::texgen
