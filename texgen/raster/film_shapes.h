#pragma once

#include "core/foam/frame.h"
#include "texgen/raster/pixel_arc.h"

#include <span>
#include <vector>

namespace foam::texgen {

/// The arcs of all films, each as its forward side, in pixels of a scale (pixels per foam unit).
std::vector<PixelArc> film_shapes(const Frame& frame, double scale, int threads);

/// One of them as a side of its film; without a branch, as nobody foresees which way it is walked.
inline PixelArc shape_along(std::span<const PixelArc> shapes, HalfEdgeId side) {
    const PixelArc& forward = shapes[index_of(film_of(side))];
    const double along = static_cast<int>(is_forward(side)) * 2 - 1;
    return {along * forward.chord, forward.cosine, along * forward.sine};
}

}  // namespace foam::texgen
