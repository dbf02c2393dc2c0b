#pragma once

#include "core/foam/frame.h"
#include "texgen/raster/raster_grid.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace foam::texgen {

/// A closed chain of straight edges, counter-clockwise around a part of a bubble, in subpixels of
/// the unshifted grid. It is unwrapped: it may leave the grid by several periods. What lies around
/// a patch is outlined as a bubble is; a chain around what is left out of it goes clockwise.
struct Outline {
    BubbleId bubble{};
    std::size_t batch = 0;  // its points are point_count points of a batch, from first_point on
    std::size_t first_point = 0;
    std::size_t point_count = 0;
    std::int32_t lowest = 0;  // range of y over its points
    std::int32_t highest = 0;
};

/// What shows of every bubble when each film covers all points within half its width.
///
/// With films of no width, neighbours share the same chain of integer points, so that the outlines
/// tile the torus exactly. With a width, a bubble has one outline per part that its films leave
/// free: mostly one, none if it is all film.
///
/// In a patch the ghost has outlines too, around everything as it has no end, and lone bubbles have
/// the ids that follow the ghost's, in their order. Outlines that no pixel sees are left out.
struct CellOutlines {
    RasterGrid grid;
    std::int32_t shear = 0;         // subpixels by which a copy one period up lies to the right
    std::vector<Outline> outlines;  // in the order of bubbles
    std::vector<std::vector<SubpixelPoint>> batches;  // as the workers left them
    int unresolved = 0;  // parts left out because their boundary did not close; 0 for a valid foam
    std::optional<BubbleId> outside = {};  // the ghost of a patch

    std::span<const SubpixelPoint> chain(const Outline& outline) const {
        return std::span(batches[outline.batch]).subspan(outline.first_point, outline.point_count);
    }
};

/// Some columns and rows of pixels, the ends left out; around a torus it is unwrapped.
struct PixelBox {
    int left = 0;
    int right = 0;
    int bottom = 0;
    int top = 0;

    int columns() const { return right - left; }
    int rows() const { return top - bottom; }
};

/// The pixels that an outline reaches into, moved by a translation.
PixelBox box_around(const CellOutlines& cells, const Outline& outline, SubpixelPoint translation);

/// film_width is the whole width in pixels. The result is the same for any number of threads, and
/// apart from `grid` itself for any shift. Throws std::invalid_argument as pixels_per_unit does, or
/// for a width that is negative or not finite.
CellOutlines outline_cells(const Frame& frame,
                           const RasterGrid& grid,
                           double film_width,
                           int threads);

}  // namespace foam::texgen
