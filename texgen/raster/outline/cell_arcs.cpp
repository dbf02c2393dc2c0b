// SPDX-License-Identifier: Apache-2.0

#include "texgen/raster/outline/cell_arcs.h"

#include "texgen/raster/arcs/film_arcs.h"
#include "texgen/raster/arcs/monotone_arc.h"
#include "texgen/raster/coords/pixel_frame.h"
#include "texgen/raster/outline/full_inset.h"
#include "texgen/raster/outline/inset.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>
#include <vector>

namespace foam::texgen {

namespace {

// Returns ArcSides::left_periods for the forward side of each film, and ArcSides::right_periods for
// its twin, indexed by half-edge. The result for a half-edge is 0 periods unless a side of the
// bubble on its left crosses the left or right border of the torus.
std::vector<std::int16_t> periods_of_sides(const Network& network) {
    std::vector<std::int16_t> periods(2 * network.film_slots());
    const auto circulate = [&](BubbleId bubble) {
        const HalfEdgeId first = network.first(bubble);
        LatticeOffset unwrapping;
        HalfEdgeId h = first;
        do {
            const LatticeOffset next_unwrapping = unwrapping + network.offset(h);
            const LatticeOffset& of_film = is_forward(h) ? unwrapping : next_unwrapping;
            periods[index_of(h)] = static_cast<std::int16_t>(of_film.i);
            unwrapping = next_unwrapping;
            h = network.next(h);
        } while (h != first);
    };
    for (const FilmId film : network.films()) {
        const HalfEdgeId side = forward_side(film);
        if (network.offset(side).i != 0) {
            circulate(network.left(side));
            circulate(network.right(side));
        }
    }
    return periods;
}

// Makes the arcs that bound the insets of bubbles, that is, the parts of bubbles that films do not
// cover. `inset` is half the film width in pixels.
class InsetArcs {
  public:
    InsetArcs(const PixelFrame& pixels, const std::vector<PixelArc>& arcs, double inset)
        : pixels_(pixels), arcs_(arcs), inset_(inset) {}

    // Appends the arcs of bubble k.
    void operator()(std::size_t k, ArcBatch& batch) {
        const auto bubble = id_at<BubbleId>(k);
        find_outline(bubble);
        const ArcLoops* full = full_.trace(outline_.sides, inset_);
        const ArcLoops& loops = full != nullptr ? *full : tracer_.trace(outline_, inset_);
        for (std::size_t loop = 0; loop < loops.loop_ends.size(); ++loop) {
            append_loop(loops.loop(loop), bubble, batch);
        }
        batch.unclosed_loops += loops.unclosed_loops;
    }

  private:
    const Network& network() const { return pixels_.frame.network; }

    // Stores the outline of a bubble, relative to the tail of the bubble's first side.
    void find_outline(BubbleId bubble) {
        outline_.clear();
        Vec2 tail = Vec2::Zero();
        const HalfEdgeId first = network().first(bubble);
        HalfEdgeId h = first;
        do {
            const PixelArc arc = arc_along(arcs_, h);
            outline_.sides.push_back({tail, arc});
            tail += arc.chord;
            h = network().next(h);
        } while (h != first);
        outline_.loop_ends.push_back(outline_.sides.size());
    }

    // Appends the arcs of a loop, with their ends rounded to subpixels. A loop is left out if the
    // area within these arcs is 0 or negative. Such a loop is too small to be visible, or its
    // bubble is invalid.
    void append_loop(std::span<const ArcLoops::Side> sides, BubbleId bubble, ArcBatch& batch) {
        const SubpixelPoint origin =
            pixels_.rounded_position(network().tail(network().first(bubble)));
        const std::size_t begin = batch.arcs.size();
        SubpixelPoint tail = origin + to_subpixel(sides.front().tail);
        for (std::size_t k = 0; k < sides.size(); ++k) {
            const ArcLoops::Side& next = sides[k + 1 < sides.size() ? k + 1 : 0];
            const SubpixelPoint head = origin + to_subpixel(next.tail);
            append_arc(sides[k].arc, tail, head, {arc_side(bubble)}, batch.arcs);
            tail = head;
        }
        const auto loop = std::span<const MonotoneArc>(batch.arcs).subspan(begin);
        if (!(twice_area(loop, arc_side(bubble)) > 0.0)) {
            batch.arcs.resize(begin);
        }
    }

    const PixelFrame& pixels_;
    const std::vector<PixelArc>& arcs_;  // indexed by film
    double inset_;
    ArcLoops outline_;
    FullInset full_;
    InsetTracer tracer_;
};

CellArcs torus_arcs(const Frame& frame, const RasterGrid& grid, double film_width, int threads) {
    constexpr std::size_t kFilmsPerTask = 2048;
    const PixelFrame pixels(frame, grid);
    const Network& network = frame.network;
    const std::vector<PixelArc> arcs = film_arcs(frame, pixels.scale, threads);
    if (film_width > 0.0) {
        const auto insets = [&] { return InsetArcs(pixels, arcs, 0.5 * film_width); };
        return make_arcs(grid, network.bubble_slots(), kBubblesPerTask, insets, threads);
    }
    const std::vector<std::int16_t> periods = periods_of_sides(network);
    const auto append = [&](std::size_t film, ArcBatch& batch) {
        const HalfEdgeId h = forward_side(id_at<FilmId>(film));
        append_arc(arcs[film],
                   pixels.rounded_position(network.tail(h)),
                   pixels.rounded_position(network.head(h)) + pixels.translation(network.offset(h)),
                   {arc_side(network.left(h)),
                    arc_side(network.right(h)),
                    periods[index_of(h)],
                    periods[index_of(twin(h))]},
                   batch.arcs);
    };
    return make_arcs(
        grid, arcs.size(), kFilmsPerTask, [&] { return append; }, threads);
}

}  // namespace

CellArcs cell_arcs(const Frame& frame, const RasterGrid& grid, double film_width, int threads) {
    if (!(film_width >= 0.0) || !std::isfinite(film_width)) {
        throw std::invalid_argument(
            fmt::format("the film width must be finite and at least 0, but is {}", film_width));
    }
    if (frame.domain.is_plane()) {
        return patch_arcs(frame, grid, film_width, threads);
    }
    CellArcs cells = torus_arcs(frame, grid, film_width, threads);
    cells.shear = shear_in_subpixels(grid, frame.domain);
    return cells;
}

}  // namespace foam::texgen
