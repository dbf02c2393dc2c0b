// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/frame.h"
#include "texgen/raster/coords/raster_grid.h"
#include "texgen/vector/chain.h"

namespace foam::texgen {

/// Converts positions in the foam to positions in a drawing. The drawing shows the same tile of a
/// torus, or the same view of the plane, as the image of the frame does. Lengths are in
/// millimeters.
struct Page {
    double width = 0.0;
    double height = 0.0;
    double scale = 1.0;    // millimeters per foam unit
    double pixel = 1.0;    // width and height of a pixel of the image
    Vec2 shift{0.0, 0.0};  // position of the origin of the foam
    Domain domain;         // the domain of the foam, in millimeters

    Vec2 operator()(const Vec2& position) const { return scale * position + shift; }
};

/// Returns the page on which the image of `grid` has the given width. Throws std::invalid_argument
/// if the grid does not fit the domain (pixels_per_unit).
Page page_of(const Domain& domain, const RasterGrid& grid, double width);

/// Returns the arc of a half-edge on the page. The arc begins at the position of the tail in
/// Frame::positions.
DrawnArc arc_on(const Page& page, const Frame& frame, HalfEdgeId h);

}  // namespace foam::texgen
