#include "texgen/raster/raster_grid.h"

#include <cmath>
#include <stdexcept>
#include <string>

namespace foam::texgen {

namespace {

constexpr double kLargestAnisotropy = 1e-6;

void check_side(int side) {
    if (side < 1 || side > kLargestSide) {
        throw std::invalid_argument("image width and height must lie in 1.." +
                                    std::to_string(kLargestSide));
    }
}

}  // namespace

double pixels_per_unit(const RasterGrid& grid, const Torus& torus) {
    if (torus.is_plane()) {
        throw std::invalid_argument("a grid covers a torus, not the plane");
    }
    check_side(grid.width);
    check_side(grid.height);
    const double across = grid.width / torus.width;
    const double up = grid.height / torus.height;
    if (!(std::abs(across / up - 1.0) <= kLargestAnisotropy)) {
        throw std::invalid_argument("image and torus must have the same aspect: pixels are square");
    }
    return across;
}

SubpixelPoint snap(const RasterGrid& grid, const Torus& torus, const Vec2& position) {
    const std::int32_t x = to_subpixel(position.x() * (grid.width / torus.width));
    const std::int32_t y = to_subpixel(position.y() * (grid.height / torus.height));
    return {wrap(x, grid.width * kSubpixel), wrap(y, grid.height * kSubpixel)};
}

}  // namespace foam::texgen
