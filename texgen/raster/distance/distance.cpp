// SPDX-License-Identifier: Apache-2.0

#include "texgen/raster/distance/distance.h"

#include "core/parallel/parallel_for.h"
#include "texgen/raster/distance/field_writer.h"
#include "texgen/raster/distance/frame_regions.h"
#include "texgen/raster/distance/region_field.h"

#include <vector>

// Every bubble is painted by itself. Its outline decides which pixels are in it (pixel_mask.h).
// Distances are measured from the arcs of the bubble (arc_view.cpp; for smooth distances,
// pixel_batch.cpp). The arcs of other bubbles do not matter, because the shortest path from a pixel
// to a film crosses no other film. A distance transform (P.-E. Danielsson, "Euclidean distance
// mapping", 1980) propagates distances from pixel to pixel instead, and measures them from pixels.
// Here distances are measured from the arcs themselves, with errors far below a pixel. The method
// is our own.

namespace foam::texgen {

namespace {

// Sets the size of each needed image to the size of the grid, and empties all other images.
void allocate(DistanceNeeds needs, const RasterGrid& grid, DistanceField& field) {
    const auto allocate_image = [&](bool needed, int channels, auto& image) {
        if (!needed) {
            image = {};
        } else if (image.width() != grid.width || image.height() != grid.height) {
            image = {grid.width, grid.height, channels};
        }
    };
    allocate_image(true, 1, field.ids);
    allocate_image(needs.distance, 1, field.distance);
    allocate_image(needs.gradient, 2, field.gradient);
    allocate_image(needs.smooth != SmoothImages::None, 1, field.smooth);
    allocate_image(needs.smooth == SmoothImages::DistanceAndGradient, 2, field.smooth_gradient);
}

// Paints regions on one thread, one after the other: writes the values of their pixels to the
// images of a distance field. Buffers are reused between regions.
class RegionPainter {
  public:
    RegionPainter(DistanceNeeds needs, DistanceField& field)
        : needs_(needs), writer_(needs, field) {}

    // Paints the pixels of a region, moved by a translation, in the given rows of the images.
    void paint(const Region& region, SubpixelPoint translation, PixelRows rows) {
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
    pixels_per_unit(grid, frame.domain);  // throws for a bad grid before memory is allocated
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
