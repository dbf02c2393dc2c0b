#pragma once

#include "core/foam/frame.h"
#include "texgen/raster/arcs/pixel_arc.h"
#include "texgen/raster/coords/raster_grid.h"

#include <cstddef>
#include <span>

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
        return {pixel(frame.positions[frame.network.tail(h)]),
                pixel_arc({scale * arc.chord, arc.half_angle})};
    }
};

/// How many have boundaries: the bubbles, the ghost, and the lone bubbles, in this order.
std::size_t region_count(const Frame& frame);

/// What lies this many pixels beyond the image is cut off, as coordinates have 32 bits; so far away
/// that the pixels do not depend on it.
inline constexpr double kGuard = kLargestSide;

/// Whether some of a loop may show: its arcs reach no farther than they are long.
bool may_show(const RasterGrid& grid, std::span<const ArcLoops::Arc> loop);

/// Of a bubble, of the ghost, or of a lone bubble, by their place in that order. Each has its
/// region on the left.
Boundaries boundaries_of(const PixelPatch& pixels, BubbleId bubble);

}  // namespace foam::texgen
