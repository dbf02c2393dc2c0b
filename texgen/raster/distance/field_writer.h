// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/raster/distance/distance_field.h"
#include "texgen/raster/distance/pixel_batch.h"
#include "texgen/raster/distance/region.h"

#include <cstddef>
#include <cstdint>

namespace foam::texgen {

/// Writes measured pixels into the images of a distance field. Borrows the field.
class FieldWriter {
  public:
    /// Precondition: the images of `field` that are needed have the size of the grid.
    FieldWriter(DistanceNeeds needs, DistanceField& field) : needs_(needs), field_(field) {}

    /// Writes a batch of a region's pixels. `box` is the region's box in the image. On a torus,
    /// columns beyond the image's width wrap around.
    void write(const PixelBatch& batch, const PixelBox& box, std::uint32_t id);

    /// Prefetches the pixels of a box in some rows of the image. Rows are far apart in memory, so
    /// hardware prefetchers do not predict them.
    void prefetch(const PixelBox& box, PixelRows rows) const;

  private:
    // Adjacent pixels of the image.
    struct Span {
        int row;
        int x;
        std::size_t first;  // position among the values of the batch
        std::size_t count;
    };

    void write_span(const PixelBatch& batch, const Span& span, std::uint32_t id);

    DistanceNeeds needs_;
    DistanceField& field_;
};

}  // namespace foam::texgen
