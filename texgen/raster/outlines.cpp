#include "texgen/raster/outlines.h"

#include "texgen/raster/flatten.h"
#include "texgen/raster/inset.h"
#include "texgen/raster/outline_batch.h"
#include "texgen/raster/parallel_for.h"
#include "texgen/raster/patch_outlines.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace foam::texgen {

namespace {

constexpr double kShortestSide = 1e-9;  // pixels; a shorter side has no direction to speak of

// A frame as the grid sees it.
struct PixelFrame {
    const Frame& frame;
    const RasterGrid& grid;
    double scale;
    std::int32_t shear;

    FilmArc arc(HalfEdgeId h) const {
        const FilmArc arc = frame.arc(h);
        return {scale * arc.chord, arc.half_angle};
    }
    SubpixelPoint junction(JunctionId junction) const {
        return snap(grid, frame.torus, frame.positions[junction]);
    }
    SubpixelPoint translation(LatticeOffset offset) const {
        return {offset.i * grid.width * kSubpixel + offset.j * shear,
                offset.j * grid.height * kSubpixel};
    }
};

// The points of a torus' junctions and films, each once. Those of a film are its inner ones,
// relative to the tail of its forward side.
class FilmChains {
  public:
    FilmChains(const PixelFrame& pixels, int threads)
        : ends_(pixels.frame.network.film_slots()),
          tasks_((ends_.size() + kFilmsPerTask - 1) / kFilmsPerTask) {
        junctions_.reserve(pixels.frame.positions.size());
        for (const Vec2& position : pixels.frame.positions) {
            junctions_.push_back(snap(pixels.grid, pixels.frame.torus, position));
        }
        parallel_for(static_cast<int>(tasks_.size()), threads, [&](int task) {
            const std::size_t begin = static_cast<std::size_t>(task) * kFilmsPerTask;
            std::vector<SubpixelPoint>& points = tasks_[static_cast<std::size_t>(task)];
            for (std::size_t k = begin; k < std::min(begin + kFilmsPerTask, ends_.size()); ++k) {
                const HalfEdgeId side = forward_side(id_at<FilmId>(k));
                append_inner_points(pixels.arc(side), Vec2::Zero(), {}, points);
                ends_[k] = points.size();
            }
        });
    }

    SubpixelPoint junction(JunctionId junction) const { return junctions_[index_of(junction)]; }

    std::span<const SubpixelPoint> of(FilmId film) const {
        const std::size_t k = index_of(film);
        const std::size_t begin = k % kFilmsPerTask == 0 ? 0 : ends_[k - 1];
        return std::span(tasks_[k / kFilmsPerTask]).subspan(begin, ends_[k] - begin);
    }

  private:
    static constexpr std::size_t kFilmsPerTask = 2048;

    std::vector<SubpixelPoint> junctions_;
    std::vector<std::size_t> ends_;  // of each film's points among those of its task
    std::vector<std::vector<SubpixelPoint>> tasks_;
};

// Outlines of bubbles whose films have no width: the films' own chains, the same on both sides.
class SharedOutliner {
  public:
    SharedOutliner(const PixelFrame& pixels, const FilmChains& chains)
        : pixels_(pixels), chains_(chains) {}

    void outline(BubbleId bubble, OutlineBatch& batch) const {
        const Network& network = pixels_.frame.network;
        const std::size_t first_point = batch.points.size();
        LatticeOffset lift;
        HalfEdgeId h = network.first(bubble);
        SubpixelPoint tail = lifted(network.tail(h), lift);
        do {
            lift = lift + network.offset(h);
            const SubpixelPoint head = lifted(network.head(h), lift);
            batch.points.push_back(tail);
            append_side(h, tail, head, batch.points);
            tail = head;
            h = network.next(h);
        } while (h != network.first(bubble));
        close_outline(batch, bubble, first_point);
    }

  private:
    SubpixelPoint lifted(JunctionId junction, LatticeOffset lift) const {
        return chains_.junction(junction) + pixels_.translation(lift);
    }

    void append_side(HalfEdgeId h,
                     SubpixelPoint tail,
                     SubpixelPoint head,
                     std::vector<SubpixelPoint>& points) const {
        const std::span<const SubpixelPoint> inner = chains_.of(film_of(h));
        if (is_forward(h)) {
            for (const SubpixelPoint point : inner) {
                points.push_back(tail + point);
            }
        } else {
            for (std::size_t k = inner.size(); k-- > 0;) {
                points.push_back(head + inner[k]);
            }
        }
    }

    const PixelFrame& pixels_;
    const FilmChains& chains_;
};

// Outlines of what films of a width leave free.
class InsetOutliner {
  public:
    InsetOutliner(const PixelFrame& pixels, double film_width)
        : pixels_(pixels), inset_(0.5 * film_width) {}

    void outline(BubbleId bubble, OutlineBatch& batch) {
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
        Vec2 at = Vec2::Zero();
        for (const HalfEdgeId h : pixels_.frame.network.around(bubble)) {
            const FilmArc arc = pixels_.arc(h);
            if (arc.chord.norm() > kShortestSide) {
                sides_.push_back(place(arc, at));
            }
            at += arc.chord;
        }
    }

    static void append_loop(std::span<const ArcLoops::Arc> arcs,
                            SubpixelPoint anchor,
                            BubbleId bubble,
                            OutlineBatch& batch) {
        const std::size_t first_point = batch.points.size();
        for (const ArcLoops::Arc& arc : arcs) {
            batch.points.push_back(anchor + to_subpixel(arc.tail));
            append_inner_points(arc.arc, arc.tail, anchor, batch.points);
        }
        if (twice_area(std::span(batch.points).subspan(first_point)) > 0) {
            close_outline(batch, bubble, first_point);
        } else {
            batch.points.resize(first_point);  // too small for subpixels, or of an invalid bubble
        }
    }

    const PixelFrame& pixels_;
    double inset_;
    std::vector<SideArc> sides_;
    InsetTracer tracer_;
};

CellOutlines shared_outlines(const PixelFrame& pixels, int threads) {
    const FilmChains chains(pixels, threads);
    const std::size_t bubbles = pixels.frame.network.bubble_slots();
    return outline_all(pixels.grid, bubbles, SharedOutliner(pixels, chains), threads);
}

CellOutlines inset_outlines(const PixelFrame& pixels, double film_width, int threads) {
    const std::size_t bubbles = pixels.frame.network.bubble_slots();
    return outline_all(pixels.grid, bubbles, InsetOutliner(pixels, film_width), threads);
}

}  // namespace

PixelBox box_around(const CellOutlines& cells, const Outline& outline, SubpixelPoint translation) {
    const auto [left, right] = std::ranges::minmax_element(
        cells.chain(outline), {}, [](SubpixelPoint point) { return point.x; });
    return {pixel_of(left->x + translation.x),
            pixel_of(right->x + translation.x) + 1,
            pixel_of(outline.lowest + translation.y),
            pixel_of(outline.highest + translation.y) + 1};
}

CellOutlines outline_cells(const Frame& frame,
                           const RasterGrid& grid,
                           double film_width,
                           int threads) {
    if (!(film_width >= 0.0) || !std::isfinite(film_width)) {
        throw std::invalid_argument("film width must be 0 or more");
    }
    if (frame.torus.is_plane()) {
        return outline_patch(frame, grid, film_width, threads);
    }
    const PixelFrame pixels{
        frame, grid, pixels_per_unit(grid, frame.torus), shear_in_subpixels(grid, frame.torus)};
    CellOutlines cells = film_width == 0.0 ? shared_outlines(pixels, threads)
                                           : inset_outlines(pixels, film_width, threads);
    cells.shear = pixels.shear;
    return cells;
}

}  // namespace foam::texgen
