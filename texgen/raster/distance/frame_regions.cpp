// SPDX-License-Identifier: Apache-2.0

#include "texgen/raster/distance/frame_regions.h"

#include "core/parallel/counting_sort.h"
#include "core/parallel/parallel_for.h"
#include "texgen/raster/distance/patch_regions.h"
#include "texgen/raster/distance/torus_regions.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace foam::texgen {

namespace {

// Regions are painted in two phases (README.md). First, paint_within_bands paints each bubble of a
// torus that is within one band of rows of the unshifted grid. Then all other regions are painted,
// sorted by bands of the image.

// The number of rows of a band, a multiple of RegionField::kTileRows and TorusRegions::kSquare.
constexpr int kBandRows = 256;

// A copy of a region that overlaps the image.
struct RegionCopy {
    const Region* region = nullptr;
    SubpixelPoint translation;  // moves the region to its copy
};

int bands_of(const RasterGrid& grid) {
    return (grid.height - 1) / kBandRows + 1;
}

PixelRows band_rows(const RasterGrid& grid, int band) {
    return {band * kBandRows, std::min((band + 1) * kBandRows, grid.height)};
}

// Calls visit(translation) for the copies of a region that overlap the rows of an image. In the
// plane, the only copy is the region itself. On a torus, a translation is the shift of the grid
// plus whole periods. It moves Region::first into the columns of the image. Columns outside of the
// image are wrapped around when the region is painted. A copy one period up is also moved to the
// right by `shear` subpixels.
template <class Visit>
void for_each_copy(const Region& region,
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
    const std::int32_t high = region.highest.y + shift.y;
    for (std::int32_t up = floor_div(region.lowest.y + shift.y, height); up * height <= high;
         ++up) {
        const std::int32_t x = shift.x - up * shear;
        const std::int32_t columns = floor_div(region.first.x + x, width) * width;
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

// Returns the copies of all regions in one bucket per band of the image, and within a bucket in the
// order of the regions.
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

// Returns true if a region is within a band of rows of the unshifted grid. A region whose first
// point (Region::first) is on the upper border of the grid belongs to the first band, which
// contains the periodic copy of this point.
bool is_within(const Region& region, const RasterGrid& grid, int band) {
    const std::int32_t height = grid.height * kSubpixel;
    const std::int32_t down = region.first.y < height ? 0 : height;
    const PixelBox box = box_around(region, {0, -down});
    const PixelRows rows = band_rows(grid, band);
    return box.bottom >= rows.begin && box.top <= rows.end;
}

// Traces the bubbles of a torus. The work is divided by bands of rows of the unshifted grid. For
// each band, one worker traces the bubbles whose Region::first is in the band, and paints those
// that are entirely within it. No other worker paints the same rows, because different bands
// contain different rows, and a shift of the grid moves all bands by the same distance. Returns the
// regions of all other bubbles.
std::vector<Region> paint_within_bands(const TorusRegions& regions,
                                       const RasterGrid& grid,
                                       std::vector<int>& workers,
                                       const PaintRegion& paint) {
    std::vector<std::vector<Region>> rest(static_cast<std::size_t>(bands_of(grid)));
    parallel_for(bands_of(grid), workers, [&](int worker, int band) {
        Region region;
        for (const auto& start : regions.starts(band * kBandRows, kBandRows)) {
            regions.trace(start, region);
            if (!is_within(region, grid, band)) {
                rest[static_cast<std::size_t>(band)].push_back(region);
                continue;
            }
            for_each_copy(region, grid, regions.shear(), [&](SubpixelPoint translation) {
                paint(worker, region, translation, {0, grid.height});
            });
        }
    });
    std::vector<Region> all;
    for (std::vector<Region>& of_band : rest) {
        std::move(of_band.begin(), of_band.end(), std::back_inserter(all));
    }
    return all;
}

}  // namespace

void paint_regions(const Frame& frame,
                   const RasterGrid& grid,
                   int workers,
                   const PaintRegion& paint) {
    std::vector<int> worker_indices(static_cast<std::size_t>(workers));
    std::iota(worker_indices.begin(), worker_indices.end(), 0);
    std::int32_t shear = 0;
    std::vector<Region> rest;
    if (frame.domain.is_plane()) {
        rest = patch_regions(frame, grid, workers);
    } else {
        const TorusRegions regions(frame, grid, workers);
        shear = regions.shear();
        rest = paint_within_bands(regions, grid, worker_indices, paint);
    }
    const Buckets<RegionCopy> copies = copies_by_band(rest, grid, shear, workers);
    parallel_for(bands_of(grid), worker_indices, [&](int worker, int band) {
        const auto k = static_cast<std::size_t>(band);
        for (const RegionCopy& copy : copies.items_of(k, k + 1)) {
            paint(worker, *copy.region, copy.translation, band_rows(grid, band));
        }
    });
}

void RegionPixels::rasterize(const Region& region, SubpixelPoint translation, PixelRows rows) {
    box_ = box_around(region, translation);
    const SubpixelPoint to_box =
        translation - SubpixelPoint{box_.left * kSubpixel, box_.bottom * kSubpixel};
    const PixelRows box_rows{std::max(rows.begin - box_.bottom, 0),
                             std::min(rows.end, box_.top) - box_.bottom};
    const Vec2 subpixels(to_box.x, to_box.y);
    offset_ = subpixels / kSubpixel;
    mask_.reset(box_.columns(), box_rows, region.kind == RegionKind::Surroundings);
    mask_.flip_right_of(region.boundary.outline(), subpixels, region.is_chain);
}

}  // namespace foam::texgen
