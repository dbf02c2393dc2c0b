#pragma once

#include "texgen/raster/distance.h"
#include "texgen/raster/pixel_batch.h"

#include <cstdint>

namespace foam::texgen {

/// Where a region lies in an image: the region's pixels (0, 0) are these, the column from 0 to the
/// image's width; around a torus, what goes beyond that width begins anew.
struct ImagePlace {
    int x = 0;
    int row = 0;
};

/// Writes measured pixels into the images of a field.
class FieldWriter {
  public:
    /// Borrows the field, whose images are those that are needed, of the grid's size.
    FieldWriter(DistanceNeeds needs, DistanceField& field) : needs_(needs), field_(field) {}

    void write(const PixelBatch& batch, ImagePlace place, std::uint32_t id);

    /// Has the memory fetched that some rows of a region, [begin, end), will be written to; they
    /// lie in the image.
    void expect(ImagePlace place, int columns, int begin, int end) const;

  private:
    struct Pixels {
        int row;
        int x;
        std::size_t first;  // in the batch
        std::size_t count;
    };

    void write_run(const PixelBatch& batch, Pixels at, std::uint32_t id);
    void write_pixels(const PixelBatch& batch, const Pixels& at, std::uint32_t id);

    DistanceNeeds needs_;
    DistanceField& field_;
};

}  // namespace foam::texgen
