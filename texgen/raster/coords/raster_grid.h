// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/geometry/domain.h"
#include "core/geometry/vec2.h"
#include "texgen/raster/coords/fixed_point.h"

#include <optional>

namespace foam::texgen {

/// The part of the plane that an image shows.
struct View {
    Vec2 center{0.0, 0.0};  // the point in the middle of the image, in foam units
    double pixels_per_unit = 1.0;

    friend bool operator==(const View& a, const View& b) = default;
};

/// The pixels that cover a torus or a view of the plane. Row 0 is the lowest. On a torus, the lower
/// left corner of pixel (0, 0) of an unshifted grid is at the origin.
///
/// Pixel (x, y) of a shifted grid is the same, to the bit, as pixel (x + shift_x, y + shift_y) of
/// the unshifted grid, wrapped around the torus. Precondition on a sheared torus: 0 <= shift_y <
/// height.
struct RasterGrid {
    int width = 0;  // all lengths are in pixels
    int height = 0;
    int shift_x = 0;
    int shift_y = 0;
    std::optional<View> view = {};  // set in the plane, where nothing is shifted or wrapped
};

/// The longest side of a grid in pixels. It ensures that coordinates of a few periods fit 32 bits.
inline constexpr int kLargestSide = 1 << 14;

/// The length in pixels below which a side of a bubble has no reliable direction and is left out.
inline constexpr double kShortestSide = 1e-9;

/// Returns the number of pixels per foam unit. Throws std::invalid_argument if a side of the grid
/// is not in [1, kLargestSide], if the grid has no view of a plane or has a view of a torus, or if
/// the pixels on a torus are not square to one part in a million.
double pixels_per_unit(const RasterGrid& grid, const Domain& domain);

/// Returns the translation from subpixels of the unshifted grid to subpixels of this one.
inline SubpixelPoint shift_of(const RasterGrid& grid) {
    return {-wrap(grid.shift_x, grid.width) * kSubpixel,
            -wrap(grid.shift_y, grid.height) * kSubpixel};
}

/// Converts a position in the home cell of a torus, in foam units, to the nearest subpixel of the
/// unshifted grid. The result is from 0 to the width and height of the grid, both included: a point
/// on the upper or right border is not wrapped to 0, which would tear the outlines around it.
class Snap {
  public:
    Snap(const RasterGrid& grid, const Domain& domain)
        : across_(grid.width / domain.width), up_(grid.height / domain.height) {}

    SubpixelPoint operator()(const Vec2& position) const {
        return {to_subpixel(position.x() * across_), to_subpixel(position.y() * up_)};
    }

  private:
    double across_;  // pixels per foam unit, in x and y
    double up_;
};

/// Converts a position in the plane, in foam units, to pixels from the lower left corner of a grid.
/// Precondition: the grid has a view.
inline Vec2 pixel_in_view(const RasterGrid& grid, const Vec2& position) {
    return grid.view->pixels_per_unit * (position - grid.view->center) +
           0.5 * Vec2(grid.width, grid.height);
}

/// Returns the displacement to the right, in subpixels, of the copy of a point one period up. The
/// copies of a grid on a sheared torus cover the plane in rows that are displaced by this amount.
std::int32_t shear_in_subpixels(const RasterGrid& grid, const Domain& domain);

}  // namespace foam::texgen
