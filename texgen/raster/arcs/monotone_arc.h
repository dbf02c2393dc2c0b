// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/network/ids.h"
#include "core/parallel/parallel_map.h"
#include "texgen/raster/arcs/pixel_arc.h"
#include "texgen/raster/coords/raster_grid.h"

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace foam::texgen {

/// The value of ArcSides::left or ArcSides::right if there is a film on that side of the arc. If
/// films have the width 0, an arc on a torus has a bubble on either side. In a patch, however, each
/// of the two bubbles beside a film of width 0 has an arc of its own, with kFilmSide on the other
/// side.
inline constexpr std::uint32_t kFilmSide = std::numeric_limits<std::uint32_t>::max();

/// The two sides of an arc: the index of the bubble on each side, or kFilmSide. On a torus, an
/// outline that crosses the left or right border of the torus is not closed. It becomes closed if
/// it is unwrapped, that is, continued on the plane beyond the border. In the unwrapped outline of
/// the bubble on the left (right), the arc is `left_periods` (`right_periods`) periods further
/// right than its coordinates say.
struct ArcSides {
    std::uint32_t left = kFilmSide;
    std::uint32_t right = kFilmSide;
    std::int16_t left_periods = 0;
    std::int16_t right_periods = 0;

    friend bool operator==(const ArcSides& a, const ArcSides& b) = default;
};

/// Returns the sides of the same arc in the opposite direction.
inline ArcSides reversed(const ArcSides& sides) {
    return {sides.right, sides.left, sides.right_periods, sides.left_periods};
}

/// Returns the value of ArcSides::left or ArcSides::right for a bubble.
inline std::uint32_t arc_side(BubbleId bubble) {
    return static_cast<std::uint32_t>(index_of(bubble));
}

/// A rising arc that is monotone in x and in y, between two bubbles or between a bubble and a film.
/// Coordinates are in subpixels; on a torus, they do not contain the shift of the grid (shift_x and
/// shift_y of RasterGrid). The arc may be outside of the image.
struct MonotoneArc {
    SubpixelPoint low;
    SubpixelPoint high;
    double sine = 0.0;  // sine of half the angle by which the arc turns left from `low` to `high`;
                        // the half angle is from -45 to 45 degrees
    ArcSides sides;

    friend bool operator==(const MonotoneArc& a, const MonotoneArc& b) = default;
};

/// The arcs that bound the visible parts of the bubbles of a frame, in no particular order.
struct CellArcs {
    RasterGrid grid;
    std::int32_t shear = 0;                         // shear_in_subpixels on a torus; 0 in the plane
    std::vector<std::vector<MonotoneArc>> batches;  // one batch per task of make_arcs
    // The number of boundary loops of insets that did not close. The inset of a bubble is the part
    // of it that films of a given width leave free (outline/inset.h). The number is 0 for a valid
    // foam, unless a raft overlaps itself.
    int unclosed_loops = 0;
    std::optional<BubbleId> ghost = {};  // the ghost bubble of a patch
};

/// The arcs that one task of make_arcs creates. `unclosed_loops` is as in CellArcs.
struct ArcBatch {
    std::vector<MonotoneArc> arcs;
    int unclosed_loops = 0;
};

/// Appends the monotone pieces of an arc whose ends have been rounded to `tail` and `head`. The
/// ends of the pieces are rounded to subpixels, too. `sides` refers to the direction from tail to
/// head. A piece whose rounded ends have the same y is left out, because it does not affect any
/// pixel.
void append_arc(const PixelArc& arc,
                SubpixelPoint tail,
                SubpixelPoint head,
                const ArcSides& sides,
                std::vector<MonotoneArc>& to);

/// Appends a monotone piece, unless its ends have the same y. `sine` is the sine of half the angle
/// by which the piece turns left from tail to head.
void append_piece(SubpixelPoint tail,
                  SubpixelPoint head,
                  double sine,
                  const ArcSides& sides,
                  std::vector<MonotoneArc>& to);

/// Returns twice the area within a closed chain of arcs around one bubble, in square subpixels.
/// `bubble` is the arc_side() of this bubble. The result is negative if the chain, traversed with
/// the bubble on its left, is clockwise.
double twice_area(std::span<const MonotoneArc> chain, std::uint32_t bubble);

/// The recommended number of bubbles per task of make_arcs.
inline constexpr std::size_t kBubblesPerTask = 256;

/// Calls append(k, batch) for each k in [0, count), and returns the arcs of all batches. The caller
/// sets CellArcs::shear and CellArcs::ghost. Tasks run in parallel. Each task processes up to
/// `per_task` values of k, with a function `append` of its own, which it gets from new_append().
/// `append` must add arcs to batch.arcs and the number of unclosed loops to batch.unclosed_loops.
template <class NewAppend>
CellArcs make_arcs(const RasterGrid& grid,
                   std::size_t count,
                   std::size_t per_task,
                   const NewAppend& new_append,
                   int threads) {
    const auto make = [&](std::size_t first, std::size_t last) {
        auto append = new_append();
        ArcBatch batch;
        for (std::size_t k = first; k < last; ++k) {
            append(k, batch);
        }
        return batch;
    };
    CellArcs cells;
    cells.grid = grid;
    for (ArcBatch& batch : parallel_map(count, per_task, threads, make)) {
        cells.batches.push_back(std::move(batch.arcs));
        cells.unclosed_loops += batch.unclosed_loops;
    }
    return cells;
}

}  // namespace foam::texgen
