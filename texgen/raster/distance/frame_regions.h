#pragma once

#include "core/foam/frame.h"
#include "core/parallel/counting_sort.h"
#include "texgen/raster/coords/raster_grid.h"
#include "texgen/raster/distance/distance_arc.h"
#include "texgen/raster/distance/patch_regions.h"
#include "texgen/raster/distance/pixel_mask.h"
#include "texgen/raster/distance/region.h"
#include "texgen/raster/distance/torus_regions.h"

#include <cstdint>
#include <span>
#include <variant>

namespace foam::texgen {

/// A copy of a region that reaches into an image.
struct RegionCopy {
    std::uint32_t region = 0;   // its position among the regions
    SubpixelPoint translation;  // from the region to its copy
};

/// The regions that the pixels of an image may belong to: the bubbles of a frame and, around a
/// patch, the ghost. Borrows the frame.
class FrameRegions {
  public:
    /// The result is the same for any number of threads. Throws std::invalid_argument as
    /// pixels_per_unit does.
    FrameRegions(const Frame& frame, const RasterGrid& grid, int threads);

    FrameRegions(const FrameRegions&) = delete;
    FrameRegions& operator=(const FrameRegions&) = delete;

    /// Returns all regions in the order in which they are painted.
    std::span<const Region> regions() const;

    /// Finds the boundary of a region, moved by an offset.
    void trace(std::uint32_t region, SubpixelPoint offset, Boundary& boundary) const;

    /// Returns, for each band of rows of the image, the copies that reach into it, in the order in
    /// which they are painted.
    Buckets<RegionCopy> copies_by_band(int rows_per_band, int threads) const;

  private:
    template <class Put>
    void put_copies(std::uint32_t region, int rows_per_band, const Put& put) const;
    template <class Visit>
    void for_each_copy(std::uint32_t region, const Visit& visit) const;

    RasterGrid grid_;
    std::variant<TorusRegions, PatchRegions> source_;
};

/// One copy of a region in some rows of an image: its boundary and its pixels, relative to the
/// lower left corner of its box. The memory is reused from one copy to the next.
class RegionPixels {
  public:
    /// Places a copy. Precondition: its box reaches into the rows.
    void place(const FrameRegions& regions, const RegionCopy& copy, PixelRows rows);

    const Region& region() const { return region_; }
    /// Returns the box in the image. Around a torus it is unwrapped: it may reach beyond the last
    /// column.
    const PixelBox& box() const { return box_; }
    const Boundary& boundary() const { return boundary_; }
    const PixelMask& mask() const { return mask_; }

  private:
    Region region_;
    PixelBox box_;
    Boundary boundary_;
    PixelMask mask_;
};

}  // namespace foam::texgen
