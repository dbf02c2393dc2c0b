#pragma once

#include "core/foam/frame.h"
#include "texgen/raster/inset.h"
#include "texgen/raster/raster_grid.h"

namespace foam::texgen {

/// Closed loops of arcs, in pixels from the image's lower left corner.
using Boundaries = ArcLoops;

/// A frame in the plane as a grid with a view sees it.
struct PixelPatch {
    const Frame& frame;
    const RasterGrid& grid;
    double scale;  // pixels per foam unit

    Vec2 pixel(const Vec2& position) const { return pixel_in_view(grid, position); }
    ArcLoops::Arc arc(HalfEdgeId h) const {
        const FilmArc arc = frame.arc(h);
        return {pixel(frame.positions[frame.network.tail(h)]), {scale * arc.chord, arc.half_angle}};
    }
};

/// How many have boundaries: the bubbles, the ghost, and the lone bubbles, in this order.
std::size_t region_count(const Frame& frame);

/// Of a bubble, of the ghost, or of a lone bubble, by their place in that order. Each has its
/// region on the left.
Boundaries boundaries_of(const PixelPatch& pixels, BubbleId bubble);

}  // namespace foam::texgen
