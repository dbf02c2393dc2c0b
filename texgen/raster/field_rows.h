#pragma once

#include "texgen/raster/bands.h"
#include "texgen/raster/cell_mask.h"
#include "texgen/raster/region_field.h"
#include "texgen/raster/small_mask.h"

#include <algorithm>

namespace foam::texgen {

/// Some rows of an image.
struct FieldRows {
    int begin = 0;
    int end = 0;

    bool hold(const PixelBox& box) const { return begin <= box.bottom && box.top <= end; }
};

inline FieldRows rows_of(const Bands& bands, int band) {
    const int begin = bands.first_row(band);
    return {begin, begin + bands.row_count(band)};
}

/// A rectangle of the image that holds a region, or what of it is in some rows; around a torus it
/// is unwrapped.
struct FieldWindow {
    PixelBox box;
    int first_row = 0;       // of those in the mask, above the box's; as RegionField wants it
    SmallMask::Rows wanted;  // of the box

    FieldWindow(const PixelBox& around, const FieldRows& rows)
        : box(around),
          wanted{std::max(rows.begin - box.bottom, 0), std::min(box.top, rows.end) - box.bottom} {
        first_row = wanted.begin / RegionField::kTileRows * RegionField::kTileRows;
    }

    void reset(CellMask& mask) const {
        mask.reset(box.columns(), wanted.end - first_row, wanted.begin - first_row);
    }
    SubpixelPoint corner() const { return {box.left * kSubpixel, box.bottom * kSubpixel}; }
    SubpixelPoint mask_corner() const { return corner() + SubpixelPoint{0, first_row * kSubpixel}; }
};

}  // namespace foam::texgen
