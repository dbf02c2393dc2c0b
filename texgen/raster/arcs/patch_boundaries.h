#pragma once

#include "core/foam/frame.h"
#include "texgen/raster/arcs/pixel_arc.h"
#include "texgen/raster/coords/raster_grid.h"

#include <cstddef>
#include <span>

namespace foam::texgen {

/// A frame in the plane in the coordinates of a grid with a view. Borrows both.
struct PixelPatch {
    const Frame& frame;
    const RasterGrid& grid;
    double scale;  // pixels per foam unit

    Vec2 pixel(const Vec2& position) const { return pixel_in_view(grid, position); }
    ArcLoops::Side arc(HalfEdgeId h) const {
        const FilmArc arc = frame.arc(h);
        return {pixel(frame.positions[frame.network.tail(h)]),
                pixel_arc({scale * arc.chord, arc.half_angle})};
    }
};

/// Returns the number of regions: the bubbles with the ghost, then the lone bubbles.
std::size_t region_count(const Frame& frame);

/// Arcs are cut off this many pixels beyond the image, as coordinates have 32 bits; no pixel
/// depends on what is so far away.
inline constexpr double kGuard = kLargestSide;

/// Returns true if part of a loop may show. Conservative: an arc reaches no farther than its
/// length.
bool may_show(const RasterGrid& grid, std::span<const ArcLoops::Side> loop);

/// Returns the boundary loops of a region, by its index in the order of region_count, with the
/// region on their left.
ArcLoops boundaries_of(const PixelPatch& pixels, BubbleId bubble);

}  // namespace foam::texgen
