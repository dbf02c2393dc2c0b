// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/raster/coords/fixed_point.h"
#include "texgen/raster/distance/boundary.h"

#include <cstdint>

namespace foam::texgen {

enum class RegionKind {
    Bubble,
    Circle,        // a lone bubble; its boundary is a circle of two arcs
    Surroundings,  // the ghost bubble: the space around a patch and in its holes, unbounded
};

/// A region of the plane whose pixels have the same id. Positions are in the coordinates of the
/// unshifted grid. On a torus the region is unwrapped: it may extend beyond the grid by several
/// periods.
struct Region {
    std::uint32_t id = 0;  // the value of the region's pixels in DistanceField::ids
    RegionKind kind = RegionKind::Bubble;
    bool is_chain = false;  // true if all edges of the outline are straight
    SubpixelPoint first;    // the tail of the first side of the bubble; set on a torus only
    // The lower left and the upper right corner of a box around the region. In a patch, the box is
    // clipped to the image.
    SubpixelPoint lowest;
    SubpixelPoint highest;
    Boundary boundary;
};

/// The rows of pixels [begin, end).
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

/// Returns a box that contains all pixels of a region that is moved by a translation.
inline PixelBox box_around(const Region& region, SubpixelPoint translation) {
    const SubpixelPoint low = region.lowest + translation;
    const SubpixelPoint high = region.highest + translation;
    return {pixel_of(low.x), pixel_of(high.x) + 1, pixel_of(low.y), pixel_of(high.y) + 1};
}

}  // namespace foam::texgen
