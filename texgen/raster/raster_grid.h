#pragma once

#include "core/geometry/torus.h"
#include "texgen/raster/fixed_point.h"

namespace foam::texgen {

/// The pixels that cover one torus. Row 0 is the lowest; pixel (0, 0) has its lower left corner at
/// the origin of the torus when nothing is shifted.
struct RasterGrid {
    int width = 0;  // pixels; so is all that follows
    int height = 0;
    int shift_x = 0;  // pixel (x, y) shows what pixel (x + shift_x, y + shift_y) of the unshifted
    int shift_y = 0;  // grid shows, around the torus, bit for bit; 0 <= shift_y < height if sheared
};

/// The longest side of a grid, so that coordinates of a few periods fit 32 bits.
inline constexpr int kLargestSide = 1 << 14;

/// Pixels per foam unit. Throws std::invalid_argument if a side of the grid is not in [1,
/// kLargestSide] or its pixels are not square to one part in a million.
double pixels_per_unit(const RasterGrid& grid, const Torus& torus);

/// A position in the torus' own cell, in foam units, as the nearest subpixel of the unshifted grid:
/// from 0 to its width and height, both included. A point at the far border stays there, or the
/// outlines around it would be torn.
SubpixelPoint snap(const RasterGrid& grid, const Torus& torus, const Vec2& position);

/// How far the copy of a point one period up lies to the right, in subpixels: a sheared torus
/// covers the plane with grids whose rows are moved against each other.
std::int32_t shear_in_subpixels(const RasterGrid& grid, const Torus& torus);

}  // namespace foam::texgen
