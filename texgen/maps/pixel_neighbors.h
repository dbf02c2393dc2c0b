// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/geometry/domain.h"
#include "texgen/raster/coords/raster_grid.h"

#include <cstddef>

namespace foam::texgen {

/// The pixels beside a pixel, as indices that count pixels row by row from the bottom row. On a
/// torus, the first and the last column are neighbors, and so are the first and the last row unless
/// the torus is sheared. Where the image does not wrap around, a pixel at its border is its own
/// neighbor.
class PixelNeighbors {
  public:
    PixelNeighbors(const RasterGrid& grid, const Domain& domain)
        : width_(static_cast<std::size_t>(grid.width)),
          count_(width_ * static_cast<std::size_t>(grid.height)),
          wraps_x_(!domain.is_plane()),
          wraps_y_(!domain.is_plane() && shear_in_subpixels(grid, domain) == 0) {}

    std::size_t width() const { return width_; }

    std::size_t left(std::size_t index) const {
        if (index % width_ > 0) {
            return index - 1;
        }
        return wraps_x_ ? index + width_ - 1 : index;
    }
    std::size_t right(std::size_t index) const {
        if (index % width_ + 1 < width_) {
            return index + 1;
        }
        return wraps_x_ ? index + 1 - width_ : index;
    }
    std::size_t below(std::size_t index) const {
        if (index >= width_) {
            return index - width_;
        }
        return wraps_y_ ? index + count_ - width_ : index;
    }
    std::size_t above(std::size_t index) const {
        if (index + width_ < count_) {
            return index + width_;
        }
        return wraps_y_ ? index + width_ - count_ : index;
    }

  private:
    std::size_t width_;
    std::size_t count_;
    bool wraps_x_;
    bool wraps_y_;
};

}  // namespace foam::texgen
