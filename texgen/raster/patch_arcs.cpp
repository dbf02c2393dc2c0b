#include "texgen/raster/patch_arcs.h"

#include "texgen/raster/arc_batch.h"
#include "texgen/raster/arcs/clip_arc.h"
#include "texgen/raster/arcs/monotone.h"
#include "texgen/raster/arcs/patch_boundaries.h"
#include "texgen/raster/inset.h"

#include <utility>

namespace foam::texgen {

namespace {

constexpr std::size_t kBubblesPerTask = 256;

double area_of(std::span<const ArcLoops::Arc> loop) {
    double area = 0.0;
    const Vec2& origin = loop.front().tail;
    for (std::size_t k = 0; k < loop.size(); ++k) {
        const Vec2& head = loop[(k + 1) % loop.size()].tail;
        area +=
            0.5 * cross(loop[k].tail - origin, head - origin) + segment_area(film_arc(loop[k].arc));
    }
    return area;
}

// What films of a width, or none, leave free of each bubble and of what is around the patch.
class PatchArcs {
  public:
    PatchArcs(const PixelPatch& pixels, double film_width)
        : pixels_(pixels), inset_(0.5 * film_width) {}

    void make(std::size_t index, ArcBatch& batch) {
        const auto bubble = id_at<BubbleId>(index);
        const Boundaries boundaries = boundaries_of(pixels_, bubble);
        if (boundaries.arcs.empty()) {
            return;
        }
        // Near the origin, where coordinates are most exact.
        const Vec2 anchor = boundaries.arcs.front().tail;
        place_sides(boundaries, anchor);
        if (inset_ == 0.0) {
            append_loops(boundaries, Vec2::Zero(), bubble, batch);
        } else if (const ArcLoops& loops = tracer_.trace(sides_, side_ends_, inset_);
                   loops.open_ends == 0) {
            append_loops(loops, anchor, bubble, batch);
        } else {
            append_each(boundaries, anchor, bubble, batch);
        }
    }

  private:
    // Rafts that overlap, which nothing forbids, have no common boundary: each has its own then.
    // One that overlaps itself keeps its films without their outer half.
    void append_each(const Boundaries& boundaries,
                     const Vec2& anchor,
                     BubbleId bubble,
                     ArcBatch& batch) {
        std::size_t begin = 0;
        std::size_t begin_of_sides = 0;
        for (std::size_t k = 0; k < side_ends_.size(); ++k) {
            const std::size_t end = boundaries.loop_ends[k];
            const std::size_t end_of_sides = side_ends_[k];
            const ArcLoops& loops = tracer_.trace(
                std::span(sides_).subspan(begin_of_sides, end_of_sides - begin_of_sides), inset_);
            batch.unresolved += loops.open_ends;
            if (loops.open_ends == 0) {
                append_loops(loops, anchor, bubble, batch);
            } else if (bubble == pixels_.frame.network.ghost()) {
                append_loop(std::span(boundaries.arcs).subspan(begin, end - begin),
                            Vec2::Zero(),
                            bubble,
                            batch);
            }
            begin = end;
            begin_of_sides = end_of_sides;
        }
    }

    void place_sides(const Boundaries& boundaries, const Vec2& anchor) {
        sides_.clear();
        side_ends_.clear();
        std::size_t k = 0;
        for (const std::size_t end : boundaries.loop_ends) {
            for (; k < end; ++k) {
                const ArcLoops::Arc& arc = boundaries.arcs[k];
                if (arc.arc.chord.norm() > kShortestSide) {
                    sides_.push_back(place(arc.arc, arc.tail - anchor));
                }
            }
            side_ends_.push_back(sides_.size());
        }
    }

    void append_loops(const ArcLoops& loops, const Vec2& anchor, BubbleId bubble, ArcBatch& batch) {
        std::size_t begin = 0;
        for (const std::size_t end : loops.loop_ends) {
            append_loop(std::span(loops.arcs).subspan(begin, end - begin), anchor, bubble, batch);
            begin = end;
        }
    }

    // That of an invalid bubble may go clockwise; it is left out.
    void append_loop(std::span<const ArcLoops::Arc> arcs,
                     const Vec2& anchor,
                     BubbleId bubble,
                     ArcBatch& batch) {
        loop_.assign(arcs.begin(), arcs.end());
        for (ArcLoops::Arc& arc : loop_) {
            arc.tail += anchor;
        }
        if (!may_show(pixels_.grid, loop_)) {
            return;
        }
        if (bubble != pixels_.frame.network.ghost() && !(area_of(loop_) > 0.0)) {
            return;
        }
        const auto index = arc_side(bubble);
        for (std::size_t k = 0; k < loop_.size(); ++k) {
            append_side(loop_[k], loop_[(k + 1) % loop_.size()].tail, index, batch.arcs);
        }
    }

    // The same pieces from either end.
    void append_side(const ArcLoops::Arc& side,
                     const Vec2& head,
                     std::uint32_t bubble,
                     std::vector<CellArc>& to) const {
        const Vec2& tail = side.tail;
        if (std::pair(tail.x(), tail.y()) < std::pair(head.x(), head.y())) {
            append_arc(tail, head, side.arc, {bubble, kFilmSide}, to);
        } else {
            append_arc(head, tail, reversed(side.arc), {kFilmSide, bubble}, to);
        }
    }

    void append_arc(const Vec2& tail,
                    const Vec2& head,
                    const PixelArc& arc,
                    const ArcSides& sides,
                    std::vector<CellArc>& to) const {
        const MonotonePieces all(arc);
        Vec2 from = tail;
        for (std::size_t k = 0; k < all.pieces().size(); ++k) {
            const MonotonePiece& piece = all.pieces()[k];
            const Vec2 end = k + 1 < all.pieces().size() ? Vec2(tail + piece.head) : head;
            if (from.y() < end.y()) {
                append_clipped({from, end, piece.sine}, sides, to);
            } else if (end.y() < from.y()) {
                append_clipped({end, from, -piece.sine}, {sides.right, sides.left}, to);
            }
            from = end;
        }
    }

    void append_clipped(const RisingPiece& piece,
                        const ArcSides& sides,
                        std::vector<CellArc>& to) const {
        const Vec2 guard(kGuard, kGuard);
        const Vec2 size(pixels_.grid.width, pixels_.grid.height);
        const ClippedPiece clipped(piece, -guard, size + guard);
        for (const RisingPiece& part : clipped.pieces()) {
            append_piece(to_subpixel(part.low), to_subpixel(part.high), part.sine, sides, to);
        }
    }

    const PixelPatch& pixels_;
    double inset_;
    std::vector<SideArc> sides_;
    std::vector<std::size_t> side_ends_;
    std::vector<ArcLoops::Arc> loop_;
    InsetTracer tracer_;
};

}  // namespace

CellArcs arcs_of_patch(const Frame& frame, const RasterGrid& grid, double film_width, int threads) {
    const PixelPatch pixels{frame, grid, pixels_per_unit(grid, frame.domain)};
    const PatchArcs arcs(pixels, film_width);
    CellArcs cells = make_arcs(grid, region_count(frame), kBubblesPerTask, arcs, threads);
    cells.outside = frame.network.ghost();
    return cells;
}

}  // namespace foam::texgen
