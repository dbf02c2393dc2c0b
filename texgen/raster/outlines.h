#pragma once

#include "core/foam/frame.h"
#include "texgen/raster/coords/raster_grid.h"

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
    SubpixelPoint lowest;  // of x and y over its points
    SubpixelPoint highest;
};

/// The outlines of all bubbles, between films of no width: neighbours share the same chain of
/// integer points, so that the outlines tile the torus exactly.
///
/// In a patch the ghost has outlines too, around everything as it has no end, and lone bubbles have
/// the ids that follow the ghost's, in their order. Outlines that no pixel sees are left out.
struct CellOutlines {
    RasterGrid grid;
    std::int32_t shear = 0;         // subpixels by which a copy one period up lies to the right
    std::vector<Outline> outlines;  // in the order of bubbles
    std::vector<std::vector<SubpixelPoint>> batches;  // as the workers left them
    std::optional<BubbleId> outside = {};             // the ghost of a patch

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
PixelBox box_around(const Outline& outline, SubpixelPoint translation);

/// The result is the same for any number of threads, and apart from `grid` itself for any shift.
/// Throws std::invalid_argument as pixels_per_unit does.
CellOutlines outline_cells(const Frame& frame, const RasterGrid& grid, int threads);

}  // namespace foam::texgen
