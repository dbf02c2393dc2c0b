// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/raster/distance/distance_field.h"
#include "texgen/raster/distance/pixel_batch.h"
#include "texgen/raster/distance/region.h"

#include <cstddef>
#include <cstdint>

namespace foam::texgen {

/// Writes the values of batches into the images of a distance field. Borrows the field.
class FieldWriter {
  public:
    /// Precondition: the image DistanceField::ids of the field, and those images that `needs`
    /// selects, have the size of the grid.
    FieldWriter(DistanceNeeds needs, DistanceField& field) : needs_(needs), field_(field) {}

    /// Writes the values of a batch of pixels of a region. `box` is the box of the region in the
    /// image, and `id` is the id of the region. On a torus, columns outside of the image wrap
    /// around.
    void write(const PixelBatch& batch, const PixelBox& box, std::uint32_t id);

  private:
    void write_span(const PixelBatch& batch, const PixelBatch::Span& span, std::uint32_t id);

    DistanceNeeds needs_;
    DistanceField& field_;
};

}  // namespace foam::texgen
