// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/geometry/domain.h"
#include "core/geometry/vec2.h"
#include "texgen/raster/coords/fixed_point.h"

#include <optional>

namespace foam::texgen {

/// The part of the plane that an image shows. Its width and height in foam units are the width and
/// height of the image in pixels, divided by pixels_per_unit.
struct View {
    Vec2 center{0.0, 0.0};  // the point in the middle of the image, in foam units
    double pixels_per_unit = 1.0;

    friend bool operator==(const View& a, const View& b) = default;
};

/// The pixels that cover a torus or a view of the plane. Row 0 is the lowest row. On a torus, the
/// lower left corner of pixel (0, 0) of an unshifted grid is at the origin.
///
/// On a torus, a grid may be shifted. An image on the shifted grid is, to the last bit, a cyclic
/// shift of the image on the unshifted grid. Its pixel (x, y) equals pixel
/// (x + shift_x, y + shift_y) of the unshifted image, wrapped around the torus. Exception on a
/// sheared torus: a row that is wrapped in y is also displaced by the shear, which need not be a
/// whole number of pixels. A sheared torus requires 0 <= shift_y < height.
struct RasterGrid {
    int width = 0;  // this and the other lengths are in pixels
    int height = 0;
    int shift_x = 0;
    int shift_y = 0;
    std::optional<View> view = {};  // set in the plane, where nothing is shifted or wrapped
};

/// The largest width and height of a grid in pixels. The limit ensures that coordinates in
/// subpixels fit in 32 bits, even for points that are a few periods away from the grid.
inline constexpr int kMaxGridSide = 1 << 14;

/// The length, in pixels, up to which a chord is too short to have a reliable direction. Insets and
/// distance fields ignore sides of bubbles with such a chord. An inset is the part of a bubble that
/// films of a given width leave free.
inline constexpr double kShortestChord = 1e-9;

/// Returns the number of pixels per foam unit. Throws std::invalid_argument in these cases:
/// - The width or the height of the grid is not in [1, kMaxGridSide].
/// - The domain is the plane, and the grid has no view.
/// - The domain is a torus, and the grid has a view.
/// - The pixels on a torus are not square (within one part in a million).
double pixels_per_unit(const RasterGrid& grid, const Domain& domain);

/// Returns the translation, in subpixels, from coordinates on the unshifted grid to coordinates on
/// the shifted grid.
inline SubpixelPoint shift_of(const RasterGrid& grid) {
    return {-wrap(grid.shift_x, grid.width) * kSubpixel,
            -wrap(grid.shift_y, grid.height) * kSubpixel};
}

/// Converts positions in the fundamental cell of a torus, in foam units, to the nearest subpixel of
/// the unshifted grid. The x of a result is from 0 to the width of the grid, both included, and the
/// y is from 0 to the height. A point that is rounded to the upper or right border is not wrapped
/// to 0 (README.md).
class Snap {
  public:
    Snap(const RasterGrid& grid, const Domain& domain)
        : across_(grid.width / domain.width), up_(grid.height / domain.height) {}

    SubpixelPoint operator()(const Vec2& position) const {
        return {to_subpixel(position.x() * across_), to_subpixel(position.y() * up_)};
    }

  private:
    double across_;  // pixels per foam unit in x
    double up_;      // pixels per foam unit in y
};

/// Converts a position in the plane, in foam units, to pixels relative to the lower left corner of
/// a grid. Precondition: the grid has a view.
inline Vec2 pixel_in_view(const RasterGrid& grid, const Vec2& position) {
    return grid.view->pixels_per_unit * (position - grid.view->center) +
           0.5 * Vec2(grid.width, grid.height);
}

/// Returns the shear of a torus in subpixels: the displacement, to the right, of each row of copies
/// of the torus relative to the row below it. Precondition: the domain is a torus.
std::int32_t shear_in_subpixels(const RasterGrid& grid, const Domain& domain);

}  // namespace foam::texgen
