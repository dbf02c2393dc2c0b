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

/// Measures the pixels of regions in batches: the pixels of a small region at once, those of other
/// regions by tiles. The arcs that may be nearest to a tile are found by halving a region with many
/// sides again and again; sides that are too far from a part are dropped. The memory is reused from
/// one region to the next.
class RegionField {
  public:
    static constexpr int kTileColumns = 16;  // pixels
    static constexpr int kTileRows = 8;
    using Visit = std::function<void(const PixelBatch&)>;

    /// Calls visit(batch) for batches of all pixels of a region, measured.
    void measure(const Region& region,
                 const RegionPixels& pixels,
                 DistanceNeeds needs,
                 const Visit& visit);

  private:
    // A square of tiles.
    struct Block {
        int x;  // tiles
        int y;
        int tiles;  // along a side, a power of two
    };

    void measure_at_once(const PixelMask& mask, int rows);
    void halve(const PixelMask& mask, const ArcLanes& arcs, Block block, std::size_t level);
    void measure_tiles(const PixelMask& mask, const ArcLanes& arcs, Block block);
    void take_tile(const PixelMask& mask, int x, int y);
    void measure_batch(const ArcLanes& arcs, double reach);
    void measure_smooth(double reach);

    DistanceNeeds needs_;
    const Visit* visit_ = nullptr;
    const Region* region_ = nullptr;
    Vec2 offset_{0.0, 0.0};      // from the region to its pixels
    std::deque<ArcLanes> near_;  // to a part of the region, to a part of that ...
    ArcView view_;
    std::vector<ArcFunctions> functions_;
    std::vector<Vec2> points_;
    std::vector<FilmFunctions> films_;
    PixelBatch batch_;
};

}  // namespace foam::texgen
