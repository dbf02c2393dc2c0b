// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/frame.h"
#include "texgen/raster/arcs/pixel_arc.h"
#include "texgen/raster/coords/raster_grid.h"

#include <cstddef>
#include <span>

namespace foam::texgen {

/// A frame in the plane, in the pixel coordinates of a grid with a view. Borrows both.
struct PixelPatch {
    const Frame& frame;
    const RasterGrid& grid;
    double scale;  // pixels per foam unit

    /// Converts a position in foam units to pixels.
    Vec2 pixel(const Vec2& position) const { return pixel_in_view(grid, position); }
    /// Returns the arc of a side in pixels.
    ArcLoops::Side arc(HalfEdgeId h) const {
        const FilmArc arc = frame.arc(h);
        return {pixel(frame.positions[frame.network.tail(h)]),
                pixel_arc({scale * arc.chord, arc.half_angle})};
    }
};

/// Returns the number of regions: the bubbles, the ghost bubble and the lone bubbles, in this
/// order.
std::size_t region_count(const Frame& frame);

/// The distance in pixels beyond the image at which arcs are cut off, because coordinates have 32
/// bits. No pixel depends on the shape of arcs at such a distance.
inline constexpr double kGuard = kLargestSide;

/// Returns true if a part of a loop may be visible. The test is conservative: it assumes that an
/// arc may extend from its tail by its length in any direction.
bool may_be_visible(const RasterGrid& grid, std::span<const ArcLoops::Side> loop);

/// Returns the boundary loops of a region, with the region on their left. `bubble` is the index of
/// the region in the order of region_count.
ArcLoops boundaries_of(const PixelPatch& pixels, BubbleId bubble);

}  // namespace foam::texgen
