// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/geometry/domain.h"
#include "texgen/image/image.h"
#include "texgen/raster/arcs/pixel_arc.h"
#include "texgen/raster/coords/raster_grid.h"

#include <span>

namespace foam::texgen {

/// An arc, and the position of its tail in the foam.
struct PlacedArc {
    Vec2 tail{0.0, 0.0};  // foam units
    PixelArc arc;         // pixels; turns by less than 360 degrees
};

/// The distance from a point to the nearest point of an arc.
struct NearestOnArc {
    double distance = 0.0;  // in pixels
    // The direction from the nearest point of the arc to the given point, as a vector of any
    // length. For a point on the arc, a normal of the arc; at an end, the zero vector.
    Vec2 direction{0.0, 0.0};
};

/// Finds the nearest point of an arc. The given point is in pixels, relative to the tail of the
/// arc.
NearestOnArc nearest_on_arc(const PixelArc& arc, const Vec2& point);

/// Distances from the centers of pixels to the nearest of several arcs.
struct ArcDistances {
    Image<float> distance;  // one channel, in pixels; infinite beyond the reach
    Image<float> gradient;  // of the distance: x to the right, y up; zero beyond the reach
};

/// Returns the distances to the nearest of the arcs and of their periodic copies. Distances above
/// `reach`, in pixels, are infinite. Visits the pixels in a square around each arc, so it is
/// fast only for short arcs. The result does not depend on `threads`
/// (core/parallel/parallel_for.h). Precondition: pixels_per_unit does not throw for this grid and
/// this domain.
ArcDistances distances_to_arcs(std::span<const PlacedArc> arcs,
                               const RasterGrid& grid,
                               const Domain& domain,
                               double reach,
                               int threads);

/// Returns the fraction of every pixel that strokes with round ends cover, in one channel. Every
/// arc is the center line of a stroke; `width` is the full width in pixels. The fraction is
/// approximate: at the edge of a stroke it falls linearly from 1 to 0 over the width of a pixel. A
/// stroke narrower than a pixel is drawn one pixel wide, with its fractions multiplied by its
/// width. The precondition is that of distances_to_arcs.
Image<float> stroke_coverage(std::span<const PlacedArc> arcs,
                             const RasterGrid& grid,
                             const Domain& domain,
                             double width,
                             int threads);

}  // namespace foam::texgen
