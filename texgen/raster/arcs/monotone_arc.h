// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/network/ids.h"
#include "core/parallel/parallel_map.h"
#include "texgen/raster/arcs/pixel_arc.h"
#include "texgen/raster/coords/raster_grid.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace foam::texgen {

/// The value of ArcSides::left and ArcSides::right on the side of a film.
inline constexpr std::uint32_t kFilmSide = std::numeric_limits<std::uint32_t>::max();

/// The two sides of an arc. Each side has the index of a bubble, or kFilmSide, and the number of
/// periods by which the arc is further right in the closed, unwrapped outline of that bubble.
struct ArcSides {
    std::uint32_t left = kFilmSide;
    std::uint32_t right = kFilmSide;
    std::int16_t left_periods = 0;
    std::int16_t right_periods = 0;

    friend bool operator==(const ArcSides& a, const ArcSides& b) = default;
};

/// Returns the sides of the same arc, traversed the other way.
inline ArcSides reversed(const ArcSides& sides) {
    return {sides.right, sides.left, sides.right_periods, sides.left_periods};
}

inline std::uint32_t arc_side(BubbleId bubble) {
    return static_cast<std::uint32_t>(index_of(bubble));
}

/// A rising arc that is monotone in x and in y, between two bubbles or between a bubble and a film.
/// Coordinates are in subpixels of the unshifted grid.
struct MonotoneArc {
    SubpixelPoint low;
    SubpixelPoint high;
    double sine = 0.0;  // of half the angle by which the arc turns left, at most 45 degrees
    ArcSides sides;

    friend bool operator==(const MonotoneArc& a, const MonotoneArc& b) = default;
};

/// All arcs that bound the visible parts of the bubbles of a frame, in no particular order.
struct CellArcs {
    RasterGrid grid;
    std::int32_t shear = 0;  // subpixels by which a copy one period up is moved right
    std::vector<std::vector<MonotoneArc>> batches;  // one batch per task
    int unresolved = 0;  // parts left out because their boundary did not close; 0 for a valid foam
    std::optional<BubbleId> outside = {};  // the ghost bubble of a patch
};

/// The arcs that one task makes.
struct ArcBatch {
    std::vector<MonotoneArc> arcs;
    int unresolved = 0;
};

/// Appends the monotone pieces of an arc. `tail` and `head` are the rounded ends of the arc;
/// `sides` is relative to the direction from tail to head. A piece whose rounded ends have the same
/// height bounds no area and is left out.
void append_arc(const PixelArc& arc,
                SubpixelPoint tail,
                SubpixelPoint head,
                const ArcSides& sides,
                std::vector<MonotoneArc>& to);

/// Appends an arc that is monotone in x and in y, unless its ends have the same height.
void append_piece(SubpixelPoint tail,
                  SubpixelPoint head,
                  double sine,
                  const ArcSides& sides,
                  std::vector<MonotoneArc>& to);

/// Returns twice the area within a closed chain of arcs around one bubble, in square subpixels;
/// negative if the chain goes clockwise.
double twice_area(std::span<const MonotoneArc> chain, std::uint32_t bubble);

/// The number of bubbles whose arcs make_arcs should make in one task.
inline constexpr std::size_t kBubblesPerTask = 256;

/// Calls maker.make(k, batch) for each k in [0, count) and returns all arcs. Each task processes
/// `per_task` values of k with a maker of its own, which new_maker() returns.
template <class NewMaker>
CellArcs make_arcs(const RasterGrid& grid,
                   std::size_t count,
                   std::size_t per_task,
                   const NewMaker& new_maker,
                   int threads) {
    const auto make = [&](std::size_t first, std::size_t last) {
        auto maker = new_maker();
        ArcBatch batch;
        for (std::size_t k = first; k < last; ++k) {
            maker.make(k, batch);
        }
        return batch;
    };
    CellArcs cells;
    cells.grid = grid;
    for (ArcBatch& batch : parallel_map(count, per_task, threads, make)) {
        cells.batches.push_back(std::move(batch.arcs));
        cells.unresolved += batch.unresolved;
    }
    return cells;
}

}  // namespace foam::texgen
