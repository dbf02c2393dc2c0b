#include "texgen/raster/cell_arcs.h"

#include "texgen/raster/arc_batch.h"
#include "texgen/raster/film_shapes.h"
#include "texgen/raster/inset.h"
#include "texgen/raster/patch_arcs.h"
#include "texgen/raster/pixel_frame.h"

#include <cmath>
#include <stdexcept>

namespace foam::texgen {

namespace {

constexpr std::size_t kFilmsPerTask = 2048;
constexpr std::size_t kBubblesPerTask = 256;

std::uint32_t value_of(BubbleId bubble) {
    return static_cast<std::uint32_t>(index_of(bubble));
}

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
    FilmArcs(const PixelFrame& pixels,
             const std::vector<PixelArc>& shapes,
             const std::vector<SubpixelPoint>& junctions,
             const std::vector<std::int16_t>& periods)
        : pixels_(pixels), shapes_(shapes), junctions_(junctions), periods_(periods) {}

    void make(std::size_t film, ArcBatch& batch) const {
        const Network& network = pixels_.frame.network;
        const HalfEdgeId h = forward_side(id_at<FilmId>(film));
        append_arc(shapes_[film],
                   junctions_[index_of(network.tail(h))],
                   junctions_[index_of(network.head(h))] + pixels_.translation(network.offset(h)),
                   {value_of(network.left(h)),
                    value_of(network.right(h)),
                    periods_[index_of(h)],
                    periods_[index_of(twin(h))]},
                   batch.arcs);
    }

  private:
    const PixelFrame& pixels_;
    const std::vector<PixelArc>& shapes_;
    const std::vector<SubpixelPoint>& junctions_;
    const std::vector<std::int16_t>& periods_;
};

// What films of a width leave free of each bubble.
class InsetArcs {
  public:
    InsetArcs(const PixelFrame& pixels, const std::vector<PixelArc>& shapes, double film_width)
        : pixels_(pixels), shapes_(shapes), inset_(0.5 * film_width) {}

    void make(std::size_t index, ArcBatch& batch) {
        const auto bubble = id_at<BubbleId>(index);
        const Network& network = pixels_.frame.network;
        place_sides(bubble);
        const SubpixelPoint anchor = pixels_.junction(network.tail(network.first(bubble)));
        const ArcLoops& loops = tracer_.trace(sides_, inset_);
        std::size_t begin = 0;
        for (const std::size_t end : loops.loop_ends) {
            append_loop(std::span(loops.arcs).subspan(begin, end - begin), anchor, bubble, batch);
            begin = end;
        }
        batch.unresolved += loops.open_ends;
    }

  private:
    // Relative to the tail of the first.
    void place_sides(BubbleId bubble) {
        sides_.clear();
        const Network& network = pixels_.frame.network;
        Vec2 at = Vec2::Zero();
        HalfEdgeId h = network.first(bubble);
        do {
            const PixelArc& forward = shapes_[index_of(film_of(h))];
            const PixelArc arc = is_forward(h) ? forward : reversed(forward);
            if (arc.chord.norm() > kShortestSide) {
                sides_.push_back(place(arc, at));
            }
            at += arc.chord;
            h = network.next(h);
        } while (h != network.first(bubble));
    }

    static void append_loop(std::span<const ArcLoops::Arc> arcs,
                            SubpixelPoint anchor,
                            BubbleId bubble,
                            ArcBatch& batch) {
        const std::size_t begin = batch.arcs.size();
        SubpixelPoint tail = anchor + to_subpixel(arcs.front().tail);
        for (std::size_t k = 0; k < arcs.size(); ++k) {
            const ArcLoops::Arc& next = arcs[k + 1 < arcs.size() ? k + 1 : 0];
            const SubpixelPoint head = anchor + to_subpixel(next.tail);
            append_arc(arcs[k].arc, tail, head, {value_of(bubble)}, batch.arcs);
            tail = head;
        }
        const auto chain = std::span<const CellArc>(batch.arcs).subspan(begin);
        if (!(twice_area(chain, value_of(bubble)) > 0.0)) {
            batch.arcs.resize(begin);  // too small for subpixels, or of an invalid bubble
        }
    }

    const PixelFrame& pixels_;
    const std::vector<PixelArc>& shapes_;
    double inset_;
    std::vector<SideArc> sides_;
    InsetTracer tracer_;
};

CellArcs arcs_on_torus(const PixelFrame& pixels, double film_width, int threads) {
    const Network& network = pixels.frame.network;
    const std::vector<PixelArc> shapes = film_shapes(pixels.frame, pixels.scale, threads);
    if (film_width == 0.0) {
        const std::vector<std::int16_t> periods = periods_of_sides(network);
        const std::vector<SubpixelPoint> junctions = pixels.junctions();
        const FilmArcs films(pixels, shapes, junctions, periods);
        return make_arcs(pixels.grid, network.film_slots(), kFilmsPerTask, films, threads);
    }
    const InsetArcs insets(pixels, shapes, film_width);
    return make_arcs(pixels.grid, network.bubble_slots(), kBubblesPerTask, insets, threads);
}

}  // namespace

CellArcs cell_arcs(const Frame& frame, const RasterGrid& grid, double film_width, int threads) {
    if (!(film_width >= 0.0) || !std::isfinite(film_width)) {
        throw std::invalid_argument("film width must be 0 or more");
    }
    if (frame.torus.is_plane()) {
        return arcs_of_patch(frame, grid, film_width, threads);
    }
    const PixelFrame pixels(frame, grid);
    CellArcs cells = arcs_on_torus(pixels, film_width, threads);
    cells.shear = pixels.shear;
    return cells;
}

}  // namespace foam::texgen
