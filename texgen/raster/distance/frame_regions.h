// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/frame.h"
#include "texgen/raster/coords/raster_grid.h"
#include "texgen/raster/distance/pixel_mask.h"
#include "texgen/raster/distance/region.h"

#include <functional>

namespace foam::texgen {

/// A function that paints a region, moved by a translation, in some rows of an image. On a torus it
/// must wrap columns around. No two calls with the same index of a worker run at the same time.
using PaintRegion = std::function<void(
    int worker, const Region& region, SubpixelPoint translation, PixelRows rows)>;

/// Calls `paint` for all regions that may contain pixels of an image: the bubbles of a frame, and
/// the lone bubbles and the surroundings of a patch. The workers 0 to `workers` - 1 paint in
/// parallel; no two of them paint the same rows at the same time. Where regions overlap, their
/// order does not depend on the number of workers or on the shift of the grid. In a patch the
/// surroundings are painted first, then all bubbles in the order of their ids. Throws
/// std::invalid_argument if the grid is too large or empty, or if it does not fit the domain
/// (pixels_per_unit).
void paint_regions(const Frame& frame,
                   const RasterGrid& grid,
                   int workers,
                   const PaintRegion& paint);

/// The pixels of a region in some rows of an image, relative to the lower left corner of the
/// region's box. Buffers are reused between regions.
class RegionPixels {
  public:
    /// Finds the pixels of a region that is moved by a translation, in some rows of the image.
    /// Precondition: the moved box of the region overlaps the rows.
    void rasterize(const Region& region, SubpixelPoint translation, PixelRows rows);

    /// Returns the box of the region in the coordinates of the image. On a torus the box is
    /// unwrapped: it may extend beyond the first and the last column.
    const PixelBox& box() const { return box_; }
    const PixelMask& mask() const { return mask_; }
    /// Returns the translation, in pixels, from the coordinates of the region to those of the mask,
    /// whose origin is the lower left corner of box().
    const Vec2& offset() const { return offset_; }

  private:
    PixelBox box_;
    Vec2 offset_{0.0, 0.0};
    PixelMask mask_;
};

}  // namespace foam::texgen
