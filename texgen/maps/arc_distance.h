// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/geometry/domain.h"
#include "texgen/image/image.h"
#include "texgen/raster/arcs/pixel_arc.h"
#include "texgen/raster/coords/raster_grid.h"

#include <span>

namespace foam::texgen {

/// An arc somewhere in the foam.
struct PlacedArc {
    Vec2 tail{0.0, 0.0};  // foam units
    PixelArc arc;         // pixels; turns by less than 360 degrees
};

/// Returns the distance from a point to the nearest point of an arc. Both are in pixels, relative
/// to the tail of the arc.
double distance_to_arc(const PixelArc& arc, const Vec2& point);

/// Returns an image of one channel: the distance in pixels from the center of every pixel to the
/// nearest of the arcs and of their periodic copies, or `reach` if the distance is larger. Visits
/// the pixels in a square around each arc, so it serves for lines of short arcs. Throws
/// std::invalid_argument if pixels_per_unit throws it.
Image<float> distance_to_arcs(std::span<const PlacedArc> arcs,
                              const RasterGrid& grid,
                              const Domain& domain,
                              double reach);

/// Returns the fraction of every pixel that strokes with round ends cover, in one channel. Every
/// arc is the center line of a stroke; `width` is the full width in pixels. The fraction is exact
/// to first order: it is linear in the distance from the pixel's center to the edge of the stroke
/// over the width of a pixel. Strokes narrower than a pixel are paler instead. Throws as
/// distance_to_arcs does.
Image<float> stroke_coverage(std::span<const PlacedArc> arcs,
                             const RasterGrid& grid,
                             const Domain& domain,
                             double width);

}  // namespace foam::texgen
