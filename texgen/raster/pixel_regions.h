#pragma once

#include "core/foam/frame.h"
#include "texgen/raster/outlines.h"
#include "texgen/raster/region_field.h"

namespace foam::texgen {

/// A frame's regions as the grid sees them. Borrows the frame and its outlines.
class PixelRegions {
  public:
    PixelRegions(const Frame& frame, const CellOutlines& cells)
        : frame_(frame), cells_(cells), scale_(pixels_per_unit(cells.grid, frame.torus)) {}

    /// The boundaries of a region, relative to a pixel's corner.
    void place(const Outline& outline,
               SubpixelPoint translation,
               SubpixelPoint corner,
               RegionField& field) const;

    /// Those of what is around a patch, relative to the image's corner.
    void place_ghost(RegionField& field) const;

  private:
    void place_in_plane(BubbleId bubble, const Vec2& corner, RegionField& field) const;
    void place_on_torus(BubbleId bubble, const Vec2& first, RegionField& field) const;

    const Frame& frame_;
    const CellOutlines& cells_;
    double scale_;  // pixels per foam unit
};

}  // namespace foam::texgen
