// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/arcs_of_films.h"

#include "core/foam/measure.h"
#include "texgen/raster/arcs/film_arcs.h"

namespace foam::texgen {

std::vector<PlacedArc> arcs_of_films(const Frame& frame,
                                     const RasterGrid& grid,
                                     int threads,
                                     const std::function<bool(FilmId)>& is_chosen) {
    const double scale = pixels_per_unit(grid, frame.domain);
    const std::vector<PixelArc> arcs = film_arcs(frame, scale, threads);
    std::vector<PlacedArc> chosen;
    for (const FilmId film : frame.network.films()) {
        if (is_chosen(film)) {
            const JunctionId tail = frame.network.tail(forward_side(film));
            chosen.push_back({frame.positions[tail], arcs[index_of(film)]});
        }
    }
    for (const LoneBubble& bubble : frame.lone_bubbles) {
        const double radius = lone_radius(bubble);
        for (const double side : {-1.0, 1.0}) {
            const Vec2 tail = bubble.center + Vec2(side * radius, 0.0);
            const Vec2 chord(-2.0 * side * radius * scale, 0.0);
            chosen.push_back({tail, {chord, 0.0, 1.0}});
        }
    }
    return chosen;
}

}  // namespace foam::texgen
