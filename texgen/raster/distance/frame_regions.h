#pragma once

#include "core/foam/frame.h"
#include "texgen/raster/coords/raster_grid.h"
#include "texgen/raster/distance/pixel_mask.h"
#include "texgen/raster/distance/region.h"

#include <functional>

namespace foam::texgen {

/// Paints a region, moved by a translation, in some rows of an image. `worker` tells the threads
/// apart that paint at the same time.
using PaintRegion = std::function<void(
    int worker, const Region& region, SubpixelPoint translation, PixelRows rows)>;

/// Has all regions painted that the pixels of an image may belong to: the bubbles of a frame and,
/// around a patch, the ghost. Workers paint in parallel, and no two of them in the same rows.
///
/// Where regions overlap, the order in which they are painted does not depend on the number of
/// workers or on the shift of the grid; in a patch it is that of the ids, with the ghost first.
/// Throws std::invalid_argument as pixels_per_unit does.
void paint_regions(const Frame& frame,
                   const RasterGrid& grid,
                   int workers,
                   const PaintRegion& paint);

/// The pixels of a region in some rows of an image, relative to the lower left corner of its box.
/// The memory is reused from one region to the next.
class RegionPixels {
  public:
    /// Precondition: the box of the region, moved by the translation, reaches into the rows.
    void place(const Region& region, SubpixelPoint translation, PixelRows rows);

    /// Returns the box in the image. Around a torus it is unwrapped: it may reach beyond the last
    /// column.
    const PixelBox& box() const { return box_; }
    const PixelMask& mask() const { return mask_; }
    /// Returns the distance in pixels by which the region was moved to be relative to the box.
    const Vec2& offset() const { return offset_; }

  private:
    PixelBox box_;
    Vec2 offset_{0.0, 0.0};
    PixelMask mask_;
};

}  // namespace foam::texgen
