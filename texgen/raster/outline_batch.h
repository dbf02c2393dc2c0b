#pragma once

#include "texgen/raster/outlines.h"
#include "texgen/raster/parallel_for.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
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
    std::vector<OutlineBatch> batches((count + kBubblesPerTask - 1) / kBubblesPerTask);
    parallel_for(static_cast<int>(batches.size()), threads, [&](int task) {
        Outliner own = outliner;
        OutlineBatch batch;  // far from those that other threads are filling
        const std::size_t begin = static_cast<std::size_t>(task) * kBubblesPerTask;
        for (std::size_t k = begin; k < std::min(begin + kBubblesPerTask, count); ++k) {
            own.outline(id_at<BubbleId>(k), batch);
        }
        batches[static_cast<std::size_t>(task)] = std::move(batch);
    });
    return gather(grid, batches);
}

}  // namespace foam::texgen
