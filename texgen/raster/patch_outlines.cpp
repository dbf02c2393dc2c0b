#include "texgen/raster/patch_outlines.h"

#include "texgen/raster/clip.h"
#include "texgen/raster/flatten.h"
#include "texgen/raster/inset.h"
#include "texgen/raster/outline_batch.h"
#include "texgen/raster/patch_boundaries.h"

#include <cmath>
#include <utility>

namespace foam::texgen {

namespace {

constexpr double kShortestSide = 1e-9;  // pixels; a shorter side has no direction to speak of
// What lies this many pixels beyond the image is cut off, as coordinates have 32 bits; so far away
// that the pixels do not depend on it.
constexpr double kGuard = kLargestSide;

// Whether some of the loop may show: its arcs reach no farther than they are long.
bool may_show(const RasterGrid& grid, std::span<const ArcLoops::Arc> loop) {
    Vec2 low = loop.front().tail;
    Vec2 high = low;
    for (const ArcLoops::Arc& arc : loop) {
        const Vec2 reach = Vec2::Constant(arc_length(arc.arc));
        low = low.cwiseMin(arc.tail - reach);
        high = high.cwiseMax(arc.tail + reach);
    }
    return low.x() < grid.width && low.y() < grid.height && high.x() > 0.0 && high.y() > 0.0;
}

// The chain of an arc, but for its head: the same points from either end.
void append_chain(const ArcLoops::Arc& arc, const Vec2& head, std::vector<Vec2>& chain) {
    const Vec2& tail = arc.tail;
    chain.push_back(tail);
    const std::size_t first = chain.size();
    const bool tail_first = std::pair(tail.x(), tail.y()) < std::pair(head.x(), head.y());
    append_inner_points(tail_first ? arc.arc : reversed(arc.arc), tail_first ? tail : head, chain);
    if (!tail_first) {
        std::reverse(chain.begin() + static_cast<std::ptrdiff_t>(first), chain.end());
    }
}

// Outlines what films of a width, or none, leave free of each bubble and of what is around the
// patch.
class PatchOutliner {
  public:
    PatchOutliner(const PixelPatch& pixels, double film_width)
        : pixels_(pixels), inset_(0.5 * film_width) {}

    void outline(BubbleId bubble, OutlineBatch& batch) {
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
            outline_each(boundaries, anchor, bubble, batch);
        }
    }

  private:
    // Rafts that overlap, which nothing forbids, have no common boundary: each has its own then.
    // One that overlaps itself keeps its films without their outer half.
    void outline_each(const Boundaries& boundaries,
                      const Vec2& anchor,
                      BubbleId bubble,
                      OutlineBatch& batch) {
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

    void append_loops(const ArcLoops& loops,
                      const Vec2& anchor,
                      BubbleId bubble,
                      OutlineBatch& batch) {
        std::size_t begin = 0;
        for (const std::size_t end : loops.loop_ends) {
            append_loop(std::span(loops.arcs).subspan(begin, end - begin), anchor, bubble, batch);
            begin = end;
        }
    }

    void append_loop(std::span<const ArcLoops::Arc> arcs,
                     const Vec2& anchor,
                     BubbleId bubble,
                     OutlineBatch& batch) {
        loop_.assign(arcs.begin(), arcs.end());
        for (ArcLoops::Arc& arc : loop_) {
            arc.tail += anchor;
        }
        if (loop_.empty() || !may_show(pixels_.grid, loop_)) {
            return;
        }
        chain_.clear();
        for (std::size_t k = 0; k < loop_.size(); ++k) {
            append_chain(loop_[k], loop_[(k + 1) % loop_.size()].tail, chain_);
        }
        const Vec2 guard(kGuard, kGuard);
        clip_to_box(chain_, -guard, Vec2(pixels_.grid.width, pixels_.grid.height) + guard);
        append_points(bubble, batch);
    }

    // Around a bubble a loop that is too small for subpixels, or of an invalid bubble, is left out.
    void append_points(BubbleId bubble, OutlineBatch& batch) const {
        const std::size_t first_point = batch.points.size();
        for (const Vec2& point : chain_) {
            batch.points.push_back(to_subpixel(point));
        }
        const auto chain = std::span<const SubpixelPoint>(batch.points).subspan(first_point);
        const std::int64_t area = chain.empty() ? 0 : twice_area(chain);
        if (area > 0 || (area < 0 && bubble == pixels_.frame.network.ghost())) {
            close_outline(batch, bubble, first_point);
        } else {
            batch.points.resize(first_point);
        }
    }

    const PixelPatch& pixels_;
    double inset_;
    std::vector<SideArc> sides_;
    std::vector<std::size_t> side_ends_;
    std::vector<ArcLoops::Arc> loop_;
    std::vector<Vec2> chain_;
    InsetTracer tracer_;
};

}  // namespace

CellOutlines outline_patch(const Frame& frame,
                           const RasterGrid& grid,
                           double film_width,
                           int threads) {
    const PixelPatch pixels{frame, grid, pixels_per_unit(grid, frame.torus)};
    CellOutlines cells =
        outline_all(grid, region_count(frame), PatchOutliner(pixels, film_width), threads);
    cells.outside = frame.network.ghost();
    return cells;
}

}  // namespace foam::texgen
