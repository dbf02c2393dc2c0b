#include "texgen/raster/distance/distance.h"

#include "core/parallel/parallel_for.h"
#include "texgen/raster/distance/field_writer.h"
#include "texgen/raster/distance/frame_regions.h"
#include "texgen/raster/distance/region_field.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace foam::texgen {

namespace {

constexpr int kBandRows = 128;  // a multiple of RegionField::kTileRows

template <class Sample>
void allocate(bool needed, const RasterGrid& grid, int channels, Image<Sample>& image) {
    const bool fits = image.width() == grid.width && image.height() == grid.height;
    if (!needed) {
        image = {};
    } else if (!fits) {
        image = Image<Sample>(grid.width, grid.height, channels);
    }
}

void allocate(DistanceNeeds needs, const RasterGrid& grid, DistanceField& field) {
    allocate(true, grid, 1, field.ids);
    allocate(true, grid, 1, field.distance);
    allocate(needs.gradient, grid, 2, field.gradient);
    allocate(needs.smooth, grid, 1, field.smooth);
    allocate(needs.smooth, grid, 2, field.smooth_gradient);
}

// Paints regions, one after the other. The working memory is reused.
class RegionPainter {
  public:
    RegionPainter(const FrameRegions& regions, DistanceNeeds needs, DistanceField& field)
        : regions_(regions), needs_(needs), writer_(needs, field) {}

    // Paints the copies one after the other. The pixels of the next one are prefetched, unless
    // there are too many.
    void paint(std::span<const RegionCopy> copies, PixelRows rows) {
        constexpr int kMaxColumns = 64;
        for (std::size_t k = 0; k < copies.size(); ++k) {
            const RegionCopy& next = copies[std::min(k + 1, copies.size() - 1)];
            const PixelBox box = box_around(regions_.regions()[next.region], next.translation);
            if (box.columns() <= kMaxColumns) {
                writer_.prefetch(box, rows);
            }
            paint(copies[k], rows);
        }
    }

  private:
    void paint(const RegionCopy& copy, PixelRows rows) {
        pixels_.place(regions_, copy, rows);
        field_.measure(pixels_, needs_, [&](const PixelBatch& batch) {
            writer_.write(batch, pixels_.box(), pixels_.region().id);
        });
    }

    const FrameRegions& regions_;
    DistanceNeeds needs_;
    FieldWriter writer_;
    RegionPixels pixels_;
    RegionField field_;
};

}  // namespace

// Bands are painted in parallel. A region that reaches into several bands is painted in parts, so
// that no two threads write the same rows and the order of regions decides where bubbles overlap.
void write_distance_field(const Frame& frame,
                          const RasterGrid& grid,
                          DistanceNeeds needs,
                          int threads,
                          DistanceField& field) {
    const FrameRegions regions(frame, grid, threads);
    allocate(needs, grid, field);
    const int bands = (grid.height - 1) / kBandRows + 1;
    const Buckets<RegionCopy> copies = regions.copies_by_band(kBandRows, threads);
    std::vector<RegionPainter> painters(
        static_cast<std::size_t>(std::clamp(thread_count(threads), 1, bands)),
        RegionPainter(regions, needs, field));
    parallel_for(bands, painters, [&](RegionPainter& own, int band) {
        const int begin = band * kBandRows;
        const PixelRows rows{begin, std::min(begin + kBandRows, grid.height)};
        const auto k = static_cast<std::size_t>(band);
        own.paint(copies.of(k, k + 1), rows);
    });
}

DistanceField distance_field(const Frame& frame,
                             const RasterGrid& grid,
                             DistanceNeeds needs,
                             int threads) {
    DistanceField field;
    write_distance_field(frame, grid, needs, threads, field);
    return field;
}

}  // namespace foam::texgen
