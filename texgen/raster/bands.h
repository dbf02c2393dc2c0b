#pragma once

#include "texgen/raster/outlines.h"

#include <cstddef>
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

    Bands(const CellOutlines& cells, int rows_per_band);

    int count() const { return static_cast<int>(ends_.size()) - 1; }
    int first_row(int band) const { return band * rows_; }
    int row_count(int band) const;
    std::span<const Entry> entries(int band) const;

  private:
    template <class Visit>
    void for_each_entry(const CellOutlines& cells, Visit visit) const;
    // The bands that an outline reaches in one place.
    template <class Visit>
    void visit_rows(std::size_t index,
                    const Outline& outline,
                    SubpixelPoint translation,
                    Visit visit) const;

    int rows_;
    RasterGrid grid_;
    std::vector<std::size_t> ends_;  // entries of band k: from ends_[k] to ends_[k + 1]
    std::vector<Entry> entries_;
};

}  // namespace foam::texgen
