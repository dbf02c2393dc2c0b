#pragma once

#include "texgen/raster/distance/distance_field.h"
#include "texgen/raster/distance/pixel_batch.h"
#include "texgen/raster/distance/region.h"

#include <cstddef>
#include <cstdint>

namespace foam::texgen {

/// Writes measured pixels into the images of a field, which is borrowed.
class FieldWriter {
  public:
    /// Precondition: the images that are needed have the grid's size.
    FieldWriter(DistanceNeeds needs, DistanceField& field) : needs_(needs), field_(field) {}

    /// Writes a batch of a region. Around a torus, columns beyond the image's width wrap around.
    void write(const PixelBatch& batch, const PixelBox& box, std::uint32_t id);

    /// Prefetches the pixels of a box in some rows of the image: rows are far apart in memory,
    /// which processors do not predict.
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
