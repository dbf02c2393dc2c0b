#pragma once

#include "texgen/raster/outlines.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace foam::texgen {

/// Where a region reaches, in subpixels of the unshifted grid. It is unwrapped: it may leave the
/// grid by several periods.
struct RegionExtent {
    SubpixelPoint first;   // a point of its boundary
    SubpixelPoint lowest;  // of x and y over its points
    SubpixelPoint highest;
};

/// The pixels that a region reaches into, moved by a translation.
PixelBox box_around(const RegionExtent& region, SubpixelPoint translation);

/// Calls visit(translation) for all copies of a region that reach into a grid's rows, around the
/// torus and shifted as the grid says: moved by whole periods so that its first point lies within
/// the columns. `shear` are the subpixels by which a copy one period up lies to the right. In the
/// plane it is where it is.
template <class Visit>
void for_each_copy(const RasterGrid& grid,
                   std::int32_t shear,
                   const RegionExtent& region,
                   const Visit& visit) {
    if (grid.view) {
        visit(SubpixelPoint{});
        return;
    }
    const SubpixelPoint shift = shift_of(grid);
    const std::int32_t width = grid.width * kSubpixel;
    const std::int32_t height = grid.height * kSubpixel;
    const std::int32_t high = region.highest.y + shift.y;
    for (std::int32_t up = floor_div(region.lowest.y + shift.y, height); up * height <= high;
         ++up) {
        const std::int32_t x = shift.x - up * shear;
        visit(
            SubpixelPoint{x - floor_div(region.first.x + x, width) * width, shift.y - up * height});
    }
}

/// The rows of an image, cut into bands that are filled one by one, and for each band the regions
/// that reach into it, in their order; around a torus, and shifted as the grid says.
class Bands {
  public:
    /// A copy of a region; y counts from the image's row 0.
    struct Entry {
        std::uint32_t region = 0;
        SubpixelPoint translation;
    };

    /// The rows are rounded up to a power of two. `shear` as in for_each_copy.
    Bands(const RasterGrid& grid,
          std::int32_t shear,
          std::span<const RegionExtent> regions,
          int rows_per_band);

    /// Of outlines, in their order.
    Bands(const CellOutlines& cells, int rows_per_band);

    int count() const { return static_cast<int>(ends_.size()) - 1; }
    int first_row(int band) const { return band << row_bits_; }
    int row_count(int band) const;
    std::span<const Entry> entries(int band) const;

  private:
    template <class Visit>
    void visit_bands(const Entry& entry, const RegionExtent& region, const Visit& visit) const;
    int band_of(std::int32_t y) const { return y >> (kSubpixelBits + row_bits_); }

    RasterGrid grid_;
    std::int32_t shear_;
    int row_bits_;
    std::vector<std::size_t> ends_;  // entries of band k: from ends_[k] to ends_[k + 1]
    std::vector<Entry> entries_;
};

}  // namespace foam::texgen
