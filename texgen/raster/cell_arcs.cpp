#include "texgen/raster/cell_arcs.h"

#include "texgen/raster/arc_batch.h"
#include "texgen/raster/arcs/film_shapes.h"
#include "texgen/raster/coords/pixel_frame.h"
#include "texgen/raster/inset_arcs.h"
#include "texgen/raster/patch_arcs.h"

#include <cmath>
#include <stdexcept>

namespace foam::texgen {

namespace {

constexpr std::size_t kGroupsPerTask = 256;  // of films

// By how many periods further right each side's film lies in its bubble's unwrapped outline: by
// none but around bubbles of which a side crosses the torus' border.
std::vector<std::int16_t> periods_of_sides(const Network& network) {
    std::vector<std::int16_t> periods(2 * network.film_slots());
    const auto go_around = [&](BubbleId bubble) {
        const HalfEdgeId first = network.first(bubble);
        LatticeOffset lift;
        HalfEdgeId h = first;
        do {
            const LatticeOffset next_lift = lift + network.offset(h);
            const LatticeOffset& of_film = is_forward(h) ? lift : next_lift;
            periods[index_of(h)] = static_cast<std::int16_t>(of_film.i);
            lift = next_lift;
            h = network.next(h);
        } while (h != first);
    };
    for (const FilmId film : network.films()) {
        const HalfEdgeId side = forward_side(film);
        if (network.offset(side).i != 0) {
            go_around(network.left(side));
            go_around(network.right(side));
        }
    }
    return periods;
}

// The films, of no width.
class FilmArcs {
  public:
    FilmArcs(const PixelFrame& pixels, const std::vector<std::int16_t>& periods)
        : pixels_(pixels), periods_(periods) {}

    // A group of films.
    void make(std::size_t group, ArcBatch& batch) const {
        const Network& network = pixels_.frame.network;
        const auto append = [&](std::size_t film, const PixelArc& shape) {
            const HalfEdgeId h = forward_side(id_at<FilmId>(film));
            append_arc(shape,
                       pixels_.junction(network.tail(h)),
                       pixels_.junction(network.head(h)) + pixels_.translation(network.offset(h)),
                       {arc_side(network.left(h)),
                        arc_side(network.right(h)),
                        periods_[index_of(h)],
                        periods_[index_of(twin(h))]},
                       batch.arcs);
        };
        shape_some(pixels_.frame, pixels_.scale, group * kFilmsAtOnce, append);
    }

  private:
    const PixelFrame& pixels_;
    const std::vector<std::int16_t>& periods_;
};

CellArcs arcs_on_torus(const PixelFrame& pixels, double film_width, int threads) {
    const Network& network = pixels.frame.network;
    if (film_width == 0.0) {
        const std::vector<std::int16_t> periods = periods_of_sides(network);
        return make_arcs(pixels.grid,
                         (network.film_slots() + kFilmsAtOnce - 1) / kFilmsAtOnce,
                         kGroupsPerTask,
                         FilmArcs(pixels, periods),
                         threads);
    }
    const std::vector<PixelArc> shapes = film_shapes(pixels.frame, pixels.scale, threads);
    return inset_arcs(pixels, shapes, 0.5 * film_width, threads);
}

}  // namespace

CellArcs cell_arcs(const Frame& frame, const RasterGrid& grid, double film_width, int threads) {
    if (!(film_width >= 0.0) || !std::isfinite(film_width)) {
        throw std::invalid_argument("film width must be 0 or more");
    }
    if (frame.domain.is_plane()) {
        return arcs_of_patch(frame, grid, film_width, threads);
    }
    const PixelFrame pixels(frame, grid);
    CellArcs cells = arcs_on_torus(pixels, film_width, threads);
    cells.shear = pixels.shear;
    return cells;
}

}  // namespace foam::texgen
