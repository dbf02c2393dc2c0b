#include "texgen/raster/film_steps.h"

#include "texgen/raster/arcs/film_shapes.h"

namespace foam::texgen {

std::unique_ptr<FilmStep[]> film_steps(const PixelFrame& pixels,
                                       const std::vector<SubpixelPoint>& junctions,
                                       int threads) {
    const Network& network = pixels.frame.network;
    auto steps = std::make_unique_for_overwrite<FilmStep[]>(network.film_slots());
    shape_films(pixels.frame, pixels.scale, threads, [&](std::size_t film, const PixelArc& arc) {
        const HalfEdgeId forward = forward_side(id_at<FilmId>(film));
        const HalfEdgeId other = twin(forward);
        const SubpixelPoint tail = junctions[index_of(network.tail(forward))];
        const SubpixelPoint head = junctions[index_of(network.tail(other))];
        const SubpixelPoint lift = pixels.translation(network.offset(forward));
        steps[film] = {arc.chord.x(),
                       arc.chord.y(),
                       arc.cosine,
                       arc.sine,
                       {tail.x, head.x},
                       {tail.y, head.y},
                       {network.next(forward), network.next(other)},
                       lift.x,
                       lift.y};
    });
    return steps;
}

}  // namespace foam::texgen
