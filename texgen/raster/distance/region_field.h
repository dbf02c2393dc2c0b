// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/raster/distance/arc_view.h"
#include "texgen/raster/distance/distance_field.h"
#include "texgen/raster/distance/frame_regions.h"
#include "texgen/raster/distance/pixel_batch.h"

#include <deque>
#include <functional>
#include <span>
#include <vector>

namespace foam::texgen {

/// Computes the distances, gradients and smooth distances of the pixels of regions, in batches.
/// Only those are computed that the DistanceNeeds select, and those that they depend on. A region
/// is a bubble or the surroundings of a patch (Region). A small region with few arcs is one batch.
/// Any other region is subdivided recursively into tiles, as in a quadtree, and each tile is a
/// batch. If many arcs may be near a part of the region, arcs that are too far away are dropped
/// before the part is measured. Such an arc is not the nearest arc of any pixel of the part.
/// Buffers are reused between regions.
class RegionField {
  public:
    static constexpr int kTileColumns = 16;  // pixels
    static constexpr int kTileRows = 8;
    using Visit = std::function<void(const PixelBatch&)>;

    /// Measures `pixels`, the pixels of a region in some rows of the image, and calls visit(batch)
    /// for each batch. The batch is valid only during the call.
    void measure(const Region& region,
                 const RegionPixels& pixels,
                 DistanceNeeds needs,
                 const Visit& visit);

  private:
    using Arcs = std::span<const DistanceArc>;

    void subdivide(const PixelMask& mask, Arcs arcs, const PixelBox& block, std::size_t level);
    void measure_box(const PixelMask& mask, Arcs arcs, const PixelBox& box);
    void measure_distances(Arcs arcs, double reach);
    bool measure_smooth(double reach);

    DistanceNeeds needs_;
    const Visit* visit_ = nullptr;
    const Region* region_ = nullptr;
    Vec2 offset_{0.0, 0.0};  // RegionPixels::offset
    // The lists of arcs in the recursion over blocks of tiles. Each block that encloses the current
    // block and for which arcs were dropped has one list: the arcs that remain. The list of the
    // largest block is first.
    std::deque<std::vector<DistanceArc>> near_;
    ArcView view_;
    std::vector<ArcFunctions> functions_;
    std::vector<Vec2> points_;
    std::vector<FilmFunctions> films_;
    PixelBatch batch_;
};

}  // namespace foam::texgen
