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

/// Returns the distance from a point to the nearest point of an arc. Both are in pixels, relative
/// to the tail of the arc.
double distance_to_arc(const PixelArc& arc, const Vec2& point);

/// Returns an image of one channel: the distance in pixels from the center of every pixel to the
/// nearest of the arcs and of their periodic copies, or `reach` if the distance is larger. Visits
/// all pixels in a square around each arc, so it is fast only if the arcs are short. Precondition:
/// pixels_per_unit does not throw for this grid and this domain.
Image<float> distance_to_arcs(std::span<const PlacedArc> arcs,
                              const RasterGrid& grid,
                              const Domain& domain,
                              double reach);

/// Returns the fraction of every pixel that strokes with round ends cover, in one channel. Every
/// arc is the center line of a stroke; `width` is the full width in pixels. The fraction is
/// approximate: at the edge of a stroke it falls linearly from 1 to 0 over the width of a pixel. A
/// stroke narrower than a pixel is drawn one pixel wide, with its fractions multiplied by its
/// width. The precondition is that of distance_to_arcs.
Image<float> stroke_coverage(std::span<const PlacedArc> arcs,
                             const RasterGrid& grid,
                             const Domain& domain,
                             double width);

}  // namespace foam::texgen
