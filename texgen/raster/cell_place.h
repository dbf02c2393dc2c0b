#pragma once

#include "texgen/raster/cell_mask.h"
#include "texgen/raster/region_field.h"
#include "texgen/raster/row_crossings.h"
#include "texgen/raster/side_lanes.h"

namespace foam::texgen {

/// Where a bubble of a torus is drawn.
struct CellPlace {
    SubpixelPoint translation;  // of the bubble
    SubpixelPoint corner;       // of the pixel that the region is relative to
    SubpixelPoint mask;         // the same of the mask

    /// The tail of its first side, relative to the region. It is not rounded, as what the mask has
    /// is.
    Vec2 first_tail(const BubbleSides& sides) const {
        const SubpixelPoint from_corner = translation - corner;
        return sides.first + Vec2(from_corner.x, from_corner.y) / kSubpixel;
    }
};

/// Marks the boundary of a bubble in a mask, which is empty, and makes it the region.
void place_cell(const BubbleSides& sides,
                const CellPlace& at,
                RowCrossings& crossings,
                CellMask& mask,
                RegionField& region);

}  // namespace foam::texgen
