// SPDX-License-Identifier: Apache-2.0

#include "texgen/raster/arcs/monotone_arc.h"
#include "texgen/raster/arcs/patch_boundaries.h"
#include "texgen/raster/arcs/pixel_arc.h"
#include "texgen/raster/outline/cell_arcs.h"
#include "texgen/raster/outline/clip_arc.h"
#include "texgen/raster/outline/full_inset.h"
#include "texgen/raster/outline/inset.h"

#include <span>
#include <utility>
#include <vector>

// The paper treats the space around a patch as one more bubble, the ghost bubble (Section 4.2, "The
// Ghost-Bubble Method"). The rasterizer does the same. The inset of a bubble is the part of it that
// films do not cover, and what no inset covers is film. The ghost has an inset, too; the rest of
// the ghost is the outer half of the outer films. If films have the width 0, the two bubbles beside
// a film have separate arcs. Both arcs are split into pieces from the same end, so that the pieces
// are equal and the areas of the two bubbles meet without a gap. Areas of loops are sums of
// triangles (the shoelace formula) and circular segments. The fallback for rafts that overlap is
// our own.

namespace foam::texgen {

namespace {

// Returns the area within a loop, in square pixels. It is negative if the loop is clockwise.
double area_of(std::span<const ArcLoops::Side> loop) {
    double area = 0.0;
    const Vec2& origin = loop.front().tail;
    for (std::size_t k = 0; k < loop.size(); ++k) {
        const Vec2& head = loop[(k + 1) % loop.size()].tail;
        area +=
            0.5 * cross(loop[k].tail - origin, head - origin) + segment_area(film_arc(loop[k].arc));
    }
    return area;
}

// Makes the arcs that bound the insets of the regions of a patch. A region is a bubble, a lone
// bubble or the ghost bubble; its inset is the part that films do not cover. Each call makes the
// arcs of one region, whose number is `index` (region_count).
class PatchArcs {
  public:
    PatchArcs(const PixelPatch& pixels, double film_width)
        : pixels_(pixels), inset_(0.5 * film_width) {}

    void operator()(std::size_t index, ArcBatch& batch) {
        const auto bubble = id_at<BubbleId>(index);
        const ArcLoops boundaries = boundaries_of(pixels_, bubble);
        if (inset_ == 0.0) {
            append_loops(boundaries, Vec2::Zero(), bubble, batch);
        } else if (!boundaries.sides.empty()) {
            append_insets(boundaries, bubble, batch);
        }
    }

  private:
    void append_insets(const ArcLoops& boundaries, BubbleId bubble, ArcBatch& batch) {
        // Coordinates are made relative to a point of the boundary, which reduces rounding errors.
        const Vec2 anchor = boundaries.sides.front().tail;
        ArcLoops region = boundaries;
        for (ArcLoops::Side& side : region.sides) {
            side.tail -= anchor;
        }
        // FullInset finds only the insets of single loops.
        const ArcLoops* full =
            region.loop_ends.size() == 1 ? full_.trace(region.sides, inset_) : nullptr;
        const ArcLoops& loops = full != nullptr ? *full : tracer_.trace(region, inset_);
        if (loops.unclosed_loops == 0) {
            append_loops(loops, anchor, bubble, batch);
        } else {
            append_each(boundaries, region, bubble, batch);
        }
    }

    // Appends the inset of each loop by itself. The loops of the ghost bubble include the rims
    // (outer boundaries) of rafts. If rafts overlap, the boundary of the inset of all loops does
    // not close. If a raft overlaps itself, the boundary of the inset of its rim alone does not
    // close either. A loop of the ghost bubble whose own inset does not close is appended without
    // an inset. As a result, the halves of its films on the side of the ghost are not drawn. A loop
    // of any other bubble is left out if its own inset does not close. `region` is `boundaries`
    // relative to the tail of its first side.
    void append_each(const ArcLoops& boundaries,
                     const ArcLoops& region,
                     BubbleId bubble,
                     ArcBatch& batch) {
        const Vec2& anchor = boundaries.sides.front().tail;
        for (std::size_t k = 0; k < boundaries.loop_ends.size(); ++k) {
            const ArcLoops& loops = tracer_.trace_loop(region, k, inset_);
            batch.unclosed_loops += loops.unclosed_loops;
            if (loops.unclosed_loops == 0) {
                append_loops(loops, anchor, bubble, batch);
            } else if (bubble == pixels_.frame.network.ghost()) {
                append_loop(boundaries.loop(k), Vec2::Zero(), bubble, batch);
            }
        }
    }

    void append_loops(const ArcLoops& loops, const Vec2& anchor, BubbleId bubble, ArcBatch& batch) {
        for (std::size_t k = 0; k < loops.loop_ends.size(); ++k) {
            append_loop(loops.loop(k), anchor, bubble, batch);
        }
    }

    // Appends the arcs of a loop, moved by `anchor`. Leaves out a loop that cannot be visible. Also
    // leaves out a loop of any bubble but the ghost if it is clockwise or encloses no area. A
    // bubble with such a loop is invalid.
    void append_loop(std::span<const ArcLoops::Side> sides,
                     const Vec2& anchor,
                     BubbleId bubble,
                     ArcBatch& batch) {
        loop_.assign(sides.begin(), sides.end());
        for (ArcLoops::Side& side : loop_) {
            side.tail += anchor;
        }
        const bool is_ghost = bubble == pixels_.frame.network.ghost();
        if (!may_be_visible(pixels_.grid, loop_) || (!is_ghost && !(area_of(loop_) > 0.0))) {
            return;
        }
        for (std::size_t k = 0; k < loop_.size(); ++k) {
            const Vec2& head = loop_[(k + 1) % loop_.size()].tail;
            append_side(loop_[k], head, {arc_side(bubble)}, batch.arcs);
        }
    }

    // Appends the arc of a side. Splitting begins at the end of the arc with the smaller x, or with
    // the smaller y if both have the same x. Both sides of a film therefore have the same pieces.
    void append_side(const ArcLoops::Side& side,
                     const Vec2& head,
                     const ArcSides& sides,
                     std::vector<MonotoneArc>& to) const {
        const Vec2& tail = side.tail;
        if (std::pair(tail.x(), tail.y()) < std::pair(head.x(), head.y())) {
            append_pieces(tail, head, side.arc, sides, to);
        } else {
            append_pieces(head, tail, reversed(side.arc), reversed(sides), to);
        }
    }

    // Appends the monotone pieces of an arc, clipped to the image and its margin (kClipMargin).
    // Pieces whose ends have the same y are left out.
    void append_pieces(const Vec2& tail,
                       const Vec2& head,
                       const PixelArc& arc,
                       const ArcSides& sides,
                       std::vector<MonotoneArc>& to) const {
        const Vec2 margin(kClipMargin, kClipMargin);
        const Vec2 size(pixels_.grid.width, pixels_.grid.height);
        const auto inner = [&](const Vec2& at) { return Vec2(tail + at); };
        for_each_piece(arc, tail, head, inner, [&](const Vec2& from, const Vec2& end, double sine) {
            const bool rises = from.y() < end.y();
            const MonotonePiece rising =
                rises ? MonotonePiece{from, end, sine} : MonotonePiece{end, from, -sine};
            for (const MonotonePiece& part : clipped(rising, -margin, size + margin)) {
                append_piece(to_subpixel(part.tail),
                             to_subpixel(part.head),
                             part.sine,
                             rises ? sides : reversed(sides),
                             to);
            }
        });
    }

    const PixelPatch& pixels_;
    double inset_;
    std::vector<ArcLoops::Side> loop_;
    FullInset full_;
    InsetTracer tracer_;
};

}  // namespace

CellArcs patch_arcs(const Frame& frame, const RasterGrid& grid, double film_width, int threads) {
    const PixelPatch pixels{frame, grid, pixels_per_unit(grid, frame.domain)};
    const auto arcs = [&] { return PatchArcs(pixels, film_width); };
    CellArcs cells = make_arcs(grid, region_count(frame), kBubblesPerTask, arcs, threads);
    cells.ghost = frame.network.ghost();
    return cells;
}

}  // namespace foam::texgen
