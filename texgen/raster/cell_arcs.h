#pragma once

#include "core/foam/frame.h"
#include "texgen/raster/coords/raster_grid.h"

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace foam::texgen {

/// Stands for films where a bubble's index could stand.
inline constexpr std::uint32_t kFilmSide = std::numeric_limits<std::uint32_t>::max();

/// An arc that rises, and goes neither back in x nor in y, between two bubbles or a bubble and a
/// film; in subpixels of the unshifted grid.
struct CellArc {
    SubpixelPoint low;
    SubpixelPoint high;
    double sine = 0.0;  // of half the angle by which it turns left, at most 45 degrees
    std::uint32_t left = kFilmSide;
    std::uint32_t right = kFilmSide;
    // How many periods further right it lies in the closed, unwrapped outline of the bubble on its
    // left, and on its right.
    std::int16_t left_periods = 0;
    std::int16_t right_periods = 0;

    friend bool operator==(const CellArc& a, const CellArc& b) = default;
};

/// What shows of every bubble when each film covers all points within half its width: all arcs that
/// bound it, in no certain order.
///
/// With films of no width, each arc is there once, between two bubbles. With a width, a bubble is
/// bounded by one closed chain of arcs per part that its films leave free: mostly one, none if it
/// is all film.
///
/// In a patch the ghost is bounded too, without an end, and lone bubbles have the indices that
/// follow the ghost's, in their order. Arcs that no pixel sees are left out.
struct CellArcs {
    RasterGrid grid;
    std::int32_t shear = 0;  // subpixels by which a copy one period up lies to the right
    std::vector<std::vector<CellArc>> batches;  // as the workers left them
    int unresolved = 0;  // parts left out because their boundary did not close; 0 for a valid foam
    std::optional<BubbleId> outside = {};  // the ghost of a patch
};

/// film_width is the whole width in pixels. The result is the same for any number of threads, and
/// apart from `grid` itself for any shift. Throws std::invalid_argument as pixels_per_unit does, or
/// for a width that is negative or not finite.
CellArcs cell_arcs(const Frame& frame, const RasterGrid& grid, double film_width, int threads);

}  // namespace foam::texgen
