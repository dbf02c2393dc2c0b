// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/frame.h"
#include "texgen/raster/arcs/pixel_arc.h"
#include "texgen/raster/coords/raster_grid.h"

#include <span>

namespace foam::texgen {

/// A frame in the plane, in the pixel coordinates of a grid with a view. Borrows the frame and the
/// grid.
struct PixelPatch {
    const Frame& frame;
    const RasterGrid& grid;
    double scale;  // pixels per foam unit

    /// Converts a position in foam units to pixels.
    Vec2 pixel(const Vec2& position) const { return pixel_in_view(grid, position); }
    /// Returns a half-edge as a side of a loop: its tail and its arc in pixels.
    ArcLoops::Side arc(HalfEdgeId h) const {
        const FilmArc arc = frame.arc(h);
        return {pixel(frame.positions[frame.network.tail(h)]),
                pixel_arc({scale * arc.chord, arc.half_angle})};
    }
};

/// Returns the number of regions of a patch: the bubbles, the ghost bubble and the lone bubbles.
/// Regions are numbered in this order.
std::size_t region_count(const Frame& frame);

/// The width in pixels of a margin around the image. Parts of arcs beyond this margin are cut off
/// or, on the left, replaced by vertical lines (outline/clip_arc.h), so that coordinates in
/// subpixels fit in 32 bits. This does not change any pixel.
inline constexpr double kClipMargin = kMaxGridSide;

/// Returns false only if a loop neither crosses nor encloses a part of the image. The test assumes
/// that an arc may extend from its tail by its length in any direction.
bool may_be_visible(const RasterGrid& grid, std::span<const ArcLoops::Side> loop);

/// Returns the boundary loops of a region in pixels, with the region on their left. `bubble` is the
/// number of the region (region_count).
ArcLoops boundaries_of(const PixelPatch& pixels, BubbleId bubble);

}  // namespace foam::texgen
