// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/frame.h"
#include "texgen/image/image.h"
#include "texgen/raster/coords/raster_grid.h"
#include "texgen/raster/distance/distance_field.h"

#include <span>

namespace foam::texgen {

/// A moment of a cross-fade between two foams on the same torus. Borrows its members.
struct CrossFade {
    const Frame& fading_out;
    const Frame& fading_in;
    /// How far each bubble of `fading_in` has grown, from 0 (not visible) to 1 (complete), in the
    /// order of Frame::bubbles.
    std::span<const double> growth;
};

/// The border in a cross-fade: one side shows the foam that fades out, the other side the foam that
/// fades in. Every bubble of the foam that fades in grows over the foam that fades out, from a
/// point until it is complete, that is, bounded by its own films. A bubble that is in both foams
/// can instead become complete in one step (texgen/animation/LOOPS.md). The border consists of the
/// rims of growing bubbles, and of the films between complete bubbles and bubbles that are not
/// complete.
struct FadeBorder {
    /// The distance from the border in pixels: positive where the foam that fades in is shown,
    /// negative elsewhere. The distance from the rim of a growing bubble is an approximation that
    /// is exact for circles. The distance is infinite inside complete bubbles. Where the foam that
    /// fades out is shown far from the border, it is minus infinity, unless the pixel belongs to a
    /// bubble of the other foam that has begun to grow.
    Image<float> distance;
    /// The weight of the foam that fades in, from 0 to 1: the fraction of the pixel that shows it.
    Image<float> weights;
};

/// Finds the border and joins the distance fields of both foams at the border. `out` is the field
/// of CrossFade::fading_out, and `in` is the field of CrossFade::fading_in. Afterwards both fields
/// contain the same distances: from the films of the foam that is shown, or from the border if the
/// border is nearer. The ids do not change. Precondition: both fields have the same images, among
/// them the smooth distances. If the grid is shifted, the results are shifted cyclically, and no
/// bit of them changes. Throws std::invalid_argument if the grid and the domain of the frames do
/// not fit together (pixels_per_unit).
FadeBorder join_at_border(const CrossFade& fade,
                          const RasterGrid& grid,
                          int threads,
                          DistanceField& out,
                          DistanceField& in);

/// Returns the fraction of a pixel that a film covers. `width` is the width of the film. `distance`
/// is the distance of its center line from the center of the pixel. Both lengths are in pixels.
float line_coverage(double distance, double width);

}  // namespace foam::texgen
