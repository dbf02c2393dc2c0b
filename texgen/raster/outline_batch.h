#pragma once

#include "core/parallel/parallel_map.h"
#include "texgen/raster/outlines.h"

#include <cstddef>
#include <span>
#include <vector>

namespace foam::texgen {

/// The outlines that one task makes.
struct OutlineBatch {
    std::vector<Outline> outlines;
    std::vector<SubpixelPoint> points;
};

/// Takes the points from first_point on as an outline of the bubble.
void close_outline(OutlineBatch& batch, BubbleId bubble, std::size_t first_point);

/// Twice the area within a chain, in square subpixels; positive if it is counter-clockwise.
std::int64_t twice_area(std::span<const SubpixelPoint> chain);

/// All batches as one, in their order.
CellOutlines gather(const RasterGrid& grid, std::vector<OutlineBatch>& batches);

inline constexpr std::size_t kBubblesPerTask = 256;

/// Has `count` bubbles outlined, each by outliner.outline(id, batch). Every task has its own copy
/// of the outliner.
template <class Outliner>
CellOutlines outline_all(const RasterGrid& grid,
                         std::size_t count,
                         const Outliner& outliner,
                         int threads) {
    const auto outline = [&](std::size_t first, std::size_t last) {
        Outliner own = outliner;
        OutlineBatch batch;
        for (std::size_t k = first; k < last; ++k) {
            own.outline(id_at<BubbleId>(k), batch);
        }
        return batch;
    };
    std::vector<OutlineBatch> batches = parallel_map(count, kBubblesPerTask, threads, outline);
    return gather(grid, batches);
}

}  // namespace foam::texgen
