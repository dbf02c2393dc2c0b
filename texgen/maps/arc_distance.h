// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/geometry/domain.h"
#include "texgen/image/image.h"
#include "texgen/raster/arcs/pixel_arc.h"
#include "texgen/raster/coords/raster_grid.h"

#include <span>
#include <tuple>

namespace foam::texgen {

/// An arc, and the position of its tail in the foam.
struct PlacedArc {
    Vec2 tail{0.0, 0.0};  // foam units
    PixelArc arc;         // pixels; turns by less than 360 degrees
};

/// Selects what distances_to_arcs computes.
struct ArcDistanceNeeds {
    double reach = 0.0;     // in pixels; distances above it are infinite
    bool gradient = false;  // true if the gradient of the distance is needed, too

    friend bool operator<(const ArcDistanceNeeds& a, const ArcDistanceNeeds& b) {
        return std::tie(a.reach, a.gradient) < std::tie(b.reach, b.gradient);
    }
};

/// Distances from the centers of pixels to the nearest of several arcs.
struct ArcDistances {
    Image<float> distance;  // one channel, in pixels; infinite beyond the reach
    // The gradient of the distance: x to the right, y up; zero beyond the reach. The image is empty
    // unless ArcDistanceNeeds::gradient is true.
    Image<float> gradient;
};

/// Returns the distances to the nearest of the arcs and of their periodic copies. The error is at
/// most PixelBatch::kMargin, with one exception. PixelBatch::measure treats a pixel that is at most
/// 0.001 pixels beyond the normal at an end of an arc as if the pixel were between the normals at
/// both ends. The result does not depend on `threads` (core/parallel/parallel_for.h). Precondition:
/// the function pixels_per_unit (raster_grid.h) does not throw for this grid and this domain.
ArcDistances distances_to_arcs(std::span<const PlacedArc> arcs,
                               const RasterGrid& grid,
                               const Domain& domain,
                               const ArcDistanceNeeds& needs,
                               int threads);

/// Returns the value to pass to distances_to_arcs as `needs` if stroke_coverage uses the distances.
/// `width` is the full width of the strokes in pixels.
ArcDistanceNeeds stroke_needs(double width);

/// Returns the coverage of strokes with round ends: the fraction of every pixel that the strokes
/// cover, in one channel. `distance` contains the distances to the center lines of the strokes,
/// which distances_to_arcs computes with the result of stroke_needs; `width` is the full width in
/// pixels. The fraction is approximate: at the edge of a stroke it falls linearly from 1 to 0 over
/// the width of a pixel. A stroke narrower than a pixel is drawn one pixel wide, with its fractions
/// multiplied by its width.
Image<float> stroke_coverage(Image<float> distance, double width);

}  // namespace foam::texgen
