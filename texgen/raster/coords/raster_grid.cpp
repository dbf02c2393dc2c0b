// SPDX-License-Identifier: Apache-2.0

#include "texgen/raster/coords/raster_grid.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace foam::texgen {

double pixels_per_unit(const RasterGrid& grid, const Domain& domain) {
    if (std::min(grid.width, grid.height) < 1 || std::max(grid.width, grid.height) > kMaxGridSide) {
        throw std::invalid_argument("image width and height must be from 1 to " +
                                    std::to_string(kMaxGridSide));
    }
    if (domain.is_plane() != grid.view.has_value()) {
        throw std::invalid_argument(
            "a grid needs a view if the foam is in the plane, and must not have a view if the foam "
            "is on a torus");
    }
    if (grid.view) {
        return grid.view->pixels_per_unit;
    }
    const double across = grid.width / domain.width;
    const double up = grid.height / domain.height;
    constexpr double kMaxAnisotropy = 1e-6;
    if (!(std::abs(across / up - 1.0) <= kMaxAnisotropy)) {
        throw std::invalid_argument(
            "image and torus must have the same aspect ratio, because pixels are square");
    }
    return across;
}

std::int32_t shear_in_subpixels(const RasterGrid& grid, const Domain& domain) {
    return to_subpixel(domain.shear * (grid.width / domain.width));
}

}  // namespace foam::texgen
