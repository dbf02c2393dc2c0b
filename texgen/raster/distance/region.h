// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/raster/coords/fixed_point.h"
#include "texgen/raster/distance/boundary.h"

#include <cstdint>

namespace foam::texgen {

enum class RegionKind {
    Bubble,
    Circle,        // a lone bubble; its boundary is a circle of two arcs
    Surroundings,  // the surroundings of a patch; unbounded, smooth distances equal distances
};

/// A region of the plane whose pixels have the same id. Positions are in the unshifted grid. On a
/// torus the region is unwrapped: it may extend beyond the grid by several periods.
struct Region {
    std::uint32_t id = 0;  // as in DistanceField
    RegionKind kind = RegionKind::Bubble;
    bool is_chain = false;  // true if the outline has straight edges, whose crossings are exact
    SubpixelPoint first;    // the tail of the first side; torus only
    SubpixelPoint lowest;   // lower left corner of a box around the region, in subpixels
    SubpixelPoint highest;  // upper right corner
    Boundary boundary;
};

/// A range of rows of pixels.
struct PixelRows {
    int begin = 0;
    int end = 0;
};

/// A rectangle of pixels. `right` and `top` are one past the last column and row.
struct PixelBox {
    int left = 0;
    int right = 0;
    int bottom = 0;
    int top = 0;

    int columns() const { return right - left; }
    int rows() const { return top - bottom; }
    SubpixelPoint corner() const { return {left * kSubpixel, bottom * kSubpixel}; }
    bool is_within(PixelRows rows) const { return bottom >= rows.begin && top <= rows.end; }
};

/// Returns a box of the pixels that a region, moved by a translation, may cover.
inline PixelBox box_around(const Region& region, SubpixelPoint translation) {
    const SubpixelPoint low = region.lowest + translation;
    const SubpixelPoint high = region.highest + translation;
    return {pixel_of(low.x), pixel_of(high.x) + 1, pixel_of(low.y), pixel_of(high.y) + 1};
}

}  // namespace foam::texgen
