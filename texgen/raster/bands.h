#pragma once

#include "texgen/raster/outlines.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace foam::texgen {

/// The rows of an image, cut into bands that are filled one by one, and for each band the outlines
/// that reach into it; around a torus, and shifted as the grid says.
class Bands {
  public:
    /// A copy of an outline: shifted, and moved by whole periods so that its first point lies
    /// within the columns of the image; y counts from the image's row 0. In the plane it is where
    /// it is.
    struct Entry {
        std::size_t outline = 0;
        SubpixelPoint translation;
    };

    /// The rows are rounded up to a power of two.
    Bands(const CellOutlines& cells, int rows_per_band);

    int count() const { return static_cast<int>(ends_.size()) - 1; }
    int first_row(int band) const { return band << row_bits_; }
    int row_count(int band) const;
    std::span<const Entry> entries(int band) const;

  private:
    struct BandEntry {
        std::size_t band = 0;
        Entry entry{};
    };
    using Found = std::vector<BandEntry>;

    // The copies of an outline around the torus, or what of it is in the image.
    void find_copies(const CellOutlines& cells, std::size_t index, Found& found) const;
    void find_bands(const CellOutlines& cells, const Entry& whole, Found& found) const;
    void sort(const Found& found);
    int band_of(std::int32_t y) const { return y >> (kSubpixelBits + row_bits_); }

    RasterGrid grid_;
    int row_bits_;
    std::vector<std::size_t> ends_;  // entries of band k: from ends_[k] to ends_[k + 1]
    std::vector<Entry> entries_;
};

}  // namespace foam::texgen
