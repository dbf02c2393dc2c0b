// SPDX-License-Identifier: Apache-2.0

#include "texgen/raster/distance/distance.h"

#include "core/parallel/parallel_for.h"
#include "texgen/raster/distance/field_writer.h"
#include "texgen/raster/distance/frame_regions.h"
#include "texgen/raster/distance/region_field.h"

#include <cstddef>
#include <vector>

namespace foam::texgen {

namespace {

// Gives an image the size of the grid if it is needed, and empties it otherwise.
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

// The field is painted region by region. paint_regions distributes the bubbles and the surroundings
// of a patch over threads. For each region, RegionPixels finds the pixels whose centers are inside,
// RegionField computes their distances in batches, and FieldWriter stores the results. The formulas
// are in arc_view.cpp (distances) and pixel_batch.cpp (smooth distances).

// Paints regions on one thread, one after the other. Buffers are reused between regions.
class RegionPainter {
  public:
    RegionPainter(DistanceNeeds needs, DistanceField& field)
        : needs_(needs), writer_(needs, field) {}

    // Paints the pixels of a region, moved by a translation, in some rows of the images. If the
    // region has few columns, its pixels in the images are prefetched while the mask is computed.
    void paint(const Region& region, SubpixelPoint translation, PixelRows rows) {
        constexpr int kMaxColumns = 64;
        const PixelBox box = box_around(region, translation);
        if (box.columns() <= kMaxColumns) {
            writer_.prefetch(box, rows);
        }
        pixels_.rasterize(region, translation, rows);
        field_.measure(region, pixels_, needs_, [&](const PixelBatch& batch) {
            writer_.write(batch, pixels_.box(), region.id);
        });
    }

  private:
    DistanceNeeds needs_;
    FieldWriter writer_;
    RegionPixels pixels_;
    RegionField field_;
};

}  // namespace

void write_distance_field(const Frame& frame,
                          const RasterGrid& grid,
                          DistanceNeeds needs,
                          int threads,
                          DistanceField& field) {
    const int workers = thread_count(threads);
    allocate(needs, grid, field);
    std::vector<RegionPainter> painters(static_cast<std::size_t>(workers),
                                        RegionPainter(needs, field));
    paint_regions(frame,
                  grid,
                  workers,
                  [&](int worker, const Region& region, SubpixelPoint translation, PixelRows rows) {
                      painters[static_cast<std::size_t>(worker)].paint(region, translation, rows);
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
