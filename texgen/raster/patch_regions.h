#pragma once

#include "core/foam/frame.h"
#include "texgen/raster/coords/raster_grid.h"
#include "texgen/raster/region_field.h"

namespace foam::texgen {

/// The regions of a frame in the plane as a grid sees them. Borrows the frame and the grid.
class PatchRegions {
  public:
    PatchRegions(const Frame& frame, const RasterGrid& grid)
        : frame_(frame), grid_(grid), scale_(pixels_per_unit(grid, frame.domain)) {}

    /// The boundaries of a bubble, of a lone one or of what is around, relative to a pixel's
    /// corner.
    void place(BubbleId bubble, SubpixelPoint corner, RegionField& field) const;

  private:
    const Frame& frame_;
    const RasterGrid& grid_;
    double scale_;  // pixels per foam unit
};

}  // namespace foam::texgen
