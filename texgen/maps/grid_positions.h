// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/geometry/domain.h"
#include "texgen/raster/coords/raster_grid.h"

#include <cmath>
#include <cstdint>

namespace foam::texgen {

/// Returns the center of a pixel, in subpixels (1 / kSubpixel of a pixel) of the shifted grid
/// (RasterGrid::shift_x, shift_y).
inline SubpixelPoint pixel_center(int x, int y) {
    return {x * kSubpixel + kSubpixel / 2, y * kSubpixel + kSubpixel / 2};
}

/// Finds the periodic copies of a point, and calls visit(copy) for each copy that is in the image
/// or near it. Near means that the copy is, in x and in y, at most `reach` pixels outside the
/// image. The point is in foam units. A copy is in subpixels of the shifted grid. Its coordinates
/// are whole numbers, but are stored as doubles (Vec2), because in a view that magnifies a patch,
/// coordinates far outside of the image do not fit into integers of 32 bits. In the plane, a point
/// has one copy; on a torus, it has one copy for each lattice offset. The point is rounded to the
/// nearest subpixel before the shift of the grid is subtracted. Therefore, a shift moves the copies
/// by exactly whole pixels.
template <class Visit>
void for_each_copy(const RasterGrid& grid,
                   const Domain& domain,
                   const Vec2& point,
                   double reach,
                   const Visit& visit) {
    const Vec2 size(grid.width, grid.height);
    const auto is_near = [&](const Vec2& at) {
        return (at.array() >= -reach).all() && (at.array() <= size.array() + reach).all();
    };
    if (domain.is_plane()) {
        const Vec2 at = pixel_in_view(grid, point);
        if (is_near(at)) {
            visit(rounded_to_subpixels(at));
        }
        return;
    }
    const Vec2 wrapped = point - domain.translation(domain.cell_of(point));
    const SubpixelPoint shift{grid.shift_x * kSubpixel, grid.shift_y * kSubpixel};
    const SubpixelPoint first = Snap(grid, domain)(wrapped) - shift;
    const Vec2 scale(size.x() / domain.width, size.y() / domain.height);
    const Vec2 middle = 0.5 * size + Vec2(grid.shift_x, grid.shift_y);
    const Vec2 from_middle = middle.cwiseQuotient(scale) - wrapped;
    const double far = reach + 0.5 * size.maxCoeff() + 1.0;
    for (const LatticeOffset offset : domain.offsets_near(from_middle, far / scale.minCoeff())) {
        const SubpixelPoint rounded =
            first + SubpixelPoint{offset.i * grid.width * kSubpixel +
                                      offset.j * shear_in_subpixels(grid, domain),
                                  offset.j * grid.height * kSubpixel};
        const Vec2 copy(rounded.x, rounded.y);
        if (is_near(copy / kSubpixel)) {
            visit(copy);
        }
    }
}

}  // namespace foam::texgen
