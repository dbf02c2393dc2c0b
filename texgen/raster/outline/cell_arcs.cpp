// SPDX-License-Identifier: Apache-2.0

#include "texgen/raster/outline/cell_arcs.h"

#include "texgen/raster/arcs/film_arcs.h"
#include "texgen/raster/arcs/monotone_arc.h"
#include "texgen/raster/coords/pixel_frame.h"
#include "texgen/raster/outline/full_insets.h"
#include "texgen/raster/outline/inset.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>
#include <vector>

namespace foam::texgen {

namespace {

constexpr std::size_t kGroupsPerTask = 256;  // groups of films

// Returns a number of periods per half-edge, indexed by half-edge. For the arc of a film, the
// number of the forward side is ArcSides::left_periods, and the number of its twin is
// ArcSides::right_periods. The number of a half-edge is 0 unless a side of the bubble on its left
// crosses the left or right border of the torus.
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

// Makes the arcs of films whose width is 0. make() processes one group of kFilmsPerGroup films.
class FilmArcs {
  public:
    FilmArcs(const PixelFrame& pixels, const std::vector<std::int16_t>& periods)
        : pixels_(pixels), periods_(periods) {}

    void make(std::size_t group, ArcBatch& batch) const {
        const Network& network = pixels_.frame.network;
        const auto append = [&](std::size_t film, const PixelArc& arc) {
            const HalfEdgeId h = forward_side(id_at<FilmId>(film));
            append_arc(
                arc,
                pixels_.rounded_position(network.tail(h)),
                pixels_.rounded_position(network.head(h)) + pixels_.translation(network.offset(h)),
                {arc_side(network.left(h)),
                 arc_side(network.right(h)),
                 periods_[index_of(h)],
                 periods_[index_of(twin(h))]},
                batch.arcs);
        };
        for_each_arc_in_group(pixels_.frame, pixels_.scale, group * kFilmsPerGroup, append);
    }

  private:
    const PixelFrame& pixels_;
    const std::vector<std::int16_t>& periods_;
};

// Makes the arcs that bound the insets of bubbles, that is, the parts that films do not cover.
// `inset` is half the film width in pixels. make() processes one group of kBubblesPerGroup bubbles.
class InsetArcs {
  public:
    static constexpr std::size_t kBubblesPerGroup = 16;

    InsetArcs(const PixelFrame& pixels, const std::vector<PixelArc>& arcs, double inset)
        : pixels_(pixels), arcs_(arcs), inset_(inset) {}

    void make(std::size_t group, ArcBatch& batch) {
        const std::size_t first = group * kBubblesPerGroup;
        const std::size_t end = std::min(first + kBubblesPerGroup, network().bubble_slots());
        outlines_.sides.clear();
        outlines_.loop_ends.clear();
        for (std::size_t k = first; k < end; ++k) {
            add_outline(id_at<BubbleId>(k));
        }
        full_.trace(outlines_, inset_);
        for (std::size_t k = first; k < end; ++k) {
            append_inset(id_at<BubbleId>(k), k - first, batch);
        }
    }

  private:
    const Network& network() const { return pixels_.frame.network; }

    // Appends the outline of a bubble to outlines_. The coordinates are relative to the tail of the
    // bubble's first side.
    void add_outline(BubbleId bubble) {
        Vec2 tail = Vec2::Zero();
        const HalfEdgeId first = network().first(bubble);
        HalfEdgeId h = first;
        do {
            const PixelArc arc = arc_along(arcs_, h);
            outlines_.sides.push_back({tail, arc});
            tail += arc.chord;
            h = network().next(h);
        } while (h != first);
        outlines_.loop_ends.push_back(outlines_.sides.size());
    }

    // Appends the arcs of the inset of a bubble. `outline` is the index of the bubble's outline in
    // outlines_.
    void append_inset(BubbleId bubble, std::size_t outline, ArcBatch& batch) {
        const SubpixelPoint origin =
            pixels_.rounded_position(network().tail(network().first(bubble)));
        if (full_.shows_every_side(outline)) {
            inset_loop_.sides.clear();
            inset_loop_.loop_ends.clear();
            full_.append_inset(outline, inset_loop_);
            append_loop(inset_loop_.sides, origin, bubble, batch);
            return;
        }
        const ArcLoops& loops = tracer_.trace_loop(outlines_, outline, inset_);
        for (std::size_t k = 0; k < loops.loop_ends.size(); ++k) {
            append_loop(loops.loop(k), origin, bubble, batch);
        }
        batch.unclosed_loops += loops.unclosed_loops;
    }

    // Appends the arcs of a loop, unless the area within the rounded arcs is 0 or negative: such a
    // loop is too small to be visible, or its bubble is invalid.
    static void append_loop(std::span<const ArcLoops::Side> sides,
                            SubpixelPoint origin,
                            BubbleId bubble,
                            ArcBatch& batch) {
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
    ArcLoops outlines_;
    FullInsets full_;
    ArcLoops inset_loop_;
    InsetTracer tracer_;
};

CellArcs torus_arcs(const Frame& frame, const RasterGrid& grid, double film_width, int threads) {
    const PixelFrame pixels(frame, grid);
    const Network& network = frame.network;
    if (film_width == 0.0) {
        const std::vector<std::int16_t> periods = periods_of_sides(network);
        const std::size_t groups = (network.film_slots() + kFilmsPerGroup - 1) / kFilmsPerGroup;
        const auto films = [&] { return FilmArcs(pixels, periods); };
        return make_arcs(grid, groups, kGroupsPerTask, films, threads);
    }
    const std::vector<PixelArc> arcs = film_arcs(frame, pixels.scale, threads);
    const auto insets = [&] { return InsetArcs(pixels, arcs, 0.5 * film_width); };
    constexpr std::size_t kGroupSize = InsetArcs::kBubblesPerGroup;
    const std::size_t groups = (network.bubble_slots() + kGroupSize - 1) / kGroupSize;
    return make_arcs(grid, groups, kBubblesPerTask / kGroupSize, insets, threads);
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
