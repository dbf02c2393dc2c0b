#pragma once

#include "core/geometry/domain.h"
#include "core/geometry/vec2.h"
#include "texgen/raster/coords/fixed_point.h"

#include <optional>

namespace foam::texgen {

/// The part of the plane that an image shows.
struct View {
    Vec2 center{0.0, 0.0};  // shown in the middle of the image; foam units
    double pixels_per_unit = 1.0;

    friend bool operator==(const View& a, const View& b) = default;
};

/// The pixels that cover a torus or a view of the plane. Row 0 is the lowest; on a torus, pixel (0,
/// 0) has its lower left corner at the origin when nothing is shifted.
struct RasterGrid {
    int width = 0;  // pixels, as are the next three
    int height = 0;
    int shift_x = 0;  // pixel (x, y) shows what pixel (x + shift_x, y + shift_y) of the unshifted
    int shift_y = 0;  // grid shows, around the torus, bit for bit; 0 <= shift_y < height if sheared
    std::optional<View> view = {};  // of the plane, in which nothing is shifted or wrapped
};

/// The longest side of a grid, so that coordinates of a few periods fit 32 bits.
inline constexpr int kLargestSide = 1 << 14;

/// A side of a bubble that is shorter, in pixels, has no reliable direction and is left out.
inline constexpr double kShortestSide = 1e-9;

/// Returns pixels per foam unit. Throws std::invalid_argument if a side of the grid is not in [1,
/// kLargestSide], on a torus if its pixels are not square to one part in a million, in the plane if
/// the grid has no view of it.
double pixels_per_unit(const RasterGrid& grid, const Domain& domain);

/// Returns the translation from subpixels of the unshifted grid to subpixels of this one.
inline SubpixelPoint shift_of(const RasterGrid& grid) {
    return {-wrap(grid.shift_x, grid.width) * kSubpixel,
            -wrap(grid.shift_y, grid.height) * kSubpixel};
}

/// Converts a position in the torus' own cell, in foam units, to the nearest subpixel of the
/// unshifted grid: from 0 to its width and height, both included. A point on the far border stays
/// there; wrapped, it would tear the outlines around it.
class Snap {
  public:
    Snap(const RasterGrid& grid, const Domain& domain)
        : across_(grid.width / domain.width), up_(grid.height / domain.height) {}

    SubpixelPoint operator()(const Vec2& position) const {
        return {to_subpixel(position.x() * across_), to_subpixel(position.y() * up_)};
    }

  private:
    double across_;  // pixels per unit
    double up_;
};

/// Returns a position in the plane in pixels, from the lower left corner of a grid with a view.
inline Vec2 pixel_in_view(const RasterGrid& grid, const Vec2& position) {
    return grid.view->pixels_per_unit * (position - grid.view->center) +
           0.5 * Vec2(grid.width, grid.height);
}

/// Returns by how many subpixels the copy of a point one period up lies to the right. A sheared
/// torus covers the plane with rows of grids that are displaced against each other.
std::int32_t shear_in_subpixels(const RasterGrid& grid, const Domain& domain);

}  // namespace foam::texgen
