// SPDX-License-Identifier: Apache-2.0

#include "texgen/vector/page.h"

namespace foam::texgen {

Page page_of(const Domain& domain, const RasterGrid& grid, double width) {
    const double pixel = width / grid.width;
    const double scale = pixels_per_unit(grid, domain) * pixel;
    if (domain.is_plane()) {
        const double height = grid.height * pixel;
        const Vec2 shift = 0.5 * Vec2(width, height) - scale * grid.view->center;
        return {width, height, scale, pixel, shift, domain};
    }
    return {width,
            domain.height * scale,
            scale,
            pixel,
            Vec2(0.0, 0.0),
            {width, domain.height * scale, domain.shear * scale}};
}

DrawnArc arc_on(const Page& page, const Frame& frame, HalfEdgeId h) {
    const FilmArc arc = frame.arc(h);
    const Vec2& tail = frame.positions[frame.network.tail(h)];
    return {page(tail), page(tail + arc.chord), arc.half_angle};
}

}  // namespace foam::texgen
