#pragma once

#include "texgen/raster/arcs/patch_boundaries.h"
#include "texgen/raster/distance/distance_arc.h"
#include "texgen/raster/distance/region.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace foam::texgen {

/// The bubbles of a frame in the plane, its lone bubbles and what surrounds them, as a grid with a
/// view sees them. Borrows the frame and the grid.
class PatchRegions {
  public:
    PatchRegions(const Frame& frame, const RasterGrid& grid, int threads);

    /// Returns the regions that the image may show: first the surroundings, then bubbles and lone
    /// bubbles in their order. Their boxes are within the image.
    const std::vector<Region>& regions() const { return regions_; }

    /// Appends the boundary of a region, moved by an offset.
    void trace(std::size_t region, SubpixelPoint offset, Boundary& boundary) const {
        append_boundary(regions_[region].id, offset, boundary);
    }

  private:
    void append_boundary(std::uint32_t id, SubpixelPoint offset, Boundary& boundary) const;
    std::optional<Region> region_of(std::uint32_t id, Boundary& boundary) const;
    const RasterGrid& grid() const { return pixels_.grid; }

    PixelPatch pixels_;
    ArcLoops around_;  // the boundaries of the surroundings
    std::vector<Region> regions_;
};

}  // namespace foam::texgen
