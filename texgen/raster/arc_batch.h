#pragma once

#include "core/parallel/parallel_map.h"
#include "texgen/raster/arcs/pixel_arc.h"
#include "texgen/raster/cell_arcs.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace foam::texgen {

/// The arcs that one task makes.
struct ArcBatch {
    std::vector<CellArc> arcs;
    int unresolved = 0;
};

/// What an arc has on a side where a bubble shows.
inline std::uint32_t arc_side(BubbleId bubble) {
    return static_cast<std::uint32_t>(index_of(bubble));
}

/// What an arc has on its sides, as it is walked.
struct ArcSides {
    std::uint32_t left = kFilmSide;
    std::uint32_t right = kFilmSide;
    std::int16_t left_periods = 0;
    std::int16_t right_periods = 0;
};

/// Appends an arc whose ends were rounded, in pieces that rise. Those that are level, to the
/// subpixel, bound no area and are left out.
void append_arc(const PixelArc& arc,
                SubpixelPoint tail,
                SubpixelPoint head,
                const ArcSides& sides,
                std::vector<CellArc>& to);

/// Appends an arc that goes neither back in x nor in y, if it is not level. No branch depends on
/// whether it rises, which is not foreseen.
inline void append_piece(SubpixelPoint tail,
                         SubpixelPoint head,
                         double sine,
                         const ArcSides& sides,
                         std::vector<CellArc>& to) {
    if (tail.y == head.y) {
        return;
    }
    const std::size_t falls = head.y < tail.y ? 1 : 0;
    const std::size_t rises = 1 - falls;
    constexpr std::array<double, 2> kSigns{1.0, -1.0};
    const std::array<SubpixelPoint, 2> ends{tail, head};
    const std::array<std::uint32_t, 2> values{sides.left, sides.right};
    const std::array<std::int16_t, 2> periods{sides.left_periods, sides.right_periods};
    to.push_back({ends[falls],
                  ends[rises],
                  kSigns[falls] * sine,
                  values[falls],
                  values[rises],
                  periods[falls],
                  periods[rises]});
}

/// Twice the area within a closed chain of arcs around one bubble, in square subpixels; negative if
/// it goes clockwise.
double twice_area(std::span<const CellArc> chain, std::uint32_t bubble);

/// Has `count` things done by maker.make(k, batch), in tasks of `per_task`. Every task has its own
/// copy of the maker.
template <class Maker>
CellArcs make_arcs(const RasterGrid& grid,
                   std::size_t count,
                   std::size_t per_task,
                   const Maker& maker,
                   int threads) {
    const auto make = [&](std::size_t first, std::size_t last) {
        Maker own = maker;
        ArcBatch batch;
        for (std::size_t k = first; k < last; ++k) {
            own.make(k, batch);
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
