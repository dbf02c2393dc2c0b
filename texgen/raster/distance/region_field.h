// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/raster/distance/arc_lanes.h"
#include "texgen/raster/distance/arc_view.h"
#include "texgen/raster/distance/distance_field.h"
#include "texgen/raster/distance/frame_regions.h"
#include "texgen/raster/distance/pixel_batch.h"

#include <array>
#include <cstddef>
#include <deque>
#include <functional>
#include <span>
#include <vector>

namespace foam::texgen {

/// Measures the pixels of regions in batches. A small region is one batch; other regions are
/// divided into tiles. A region with many sides is subdivided recursively, as in a quadtree, and
/// arcs that are too far from a part to be the nearest one are dropped. Buffers are reused between
/// regions.
class RegionField {
  public:
    static constexpr int kTileColumns = 16;  // pixels
    static constexpr int kTileRows = 8;
    using Visit = std::function<void(const PixelBatch&)>;

    /// Measures all pixels of a region and calls visit(batch) for each batch.
    void measure(const Region& region,
                 const RegionPixels& pixels,
                 DistanceNeeds needs,
                 const Visit& visit);

  private:
    // A block with equal numbers of rows and columns of tiles.
    struct Block {
        int x;  // position of the first tile, in tiles
        int y;
        int tiles;  // number of rows and of columns of tiles, a power of two
    };

    void measure_at_once(const PixelMask& mask, int rows);
    void subdivide(const PixelMask& mask, const ArcLanes& arcs, Block block, std::size_t level);
    void measure_tiles(const PixelMask& mask, const ArcLanes& arcs, Block block);
    void take_tile(const PixelMask& mask, int x, int y);
    void measure_batch(const ArcLanes& arcs, double reach);
    void measure_smooth(double reach);

    DistanceNeeds needs_;
    const Visit* visit_ = nullptr;
    const Region* region_ = nullptr;
    Vec2 offset_{0.0, 0.0};      // translation from the region to the pixels of its box
    std::deque<ArcLanes> near_;  // the remaining arcs at each level of the recursion
    ArcView view_;
    std::vector<ArcFunctions> functions_;
    std::vector<Vec2> points_;
    std::vector<FilmFunctions> films_;
    PixelBatch batch_;
};

}  // namespace foam::texgen
