#include "texgen/raster/arcs/film_shapes.h"

namespace foam::texgen {

std::vector<PixelArc> film_shapes(const Frame& frame, double scale, int threads) {
    std::vector<PixelArc> shapes(frame.network.film_slots());
    shape_films(
        frame, scale, threads, [&](std::size_t film, const PixelArc& arc) { shapes[film] = arc; });
    return shapes;
}

}  // namespace foam::texgen
