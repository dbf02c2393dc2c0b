#include "texgen/raster/patch_outlines.h"

#include "texgen/raster/arcs/patch_boundaries.h"
#include "texgen/raster/clip.h"
#include "texgen/raster/flatten.h"
#include "texgen/raster/outline_batch.h"

#include <utility>

namespace foam::texgen {

namespace {

// The chain of an arc, but for its head: the same points from either end.
void append_chain(const ArcLoops::Arc& arc, const Vec2& head, std::vector<Vec2>& chain) {
    const Vec2& tail = arc.tail;
    chain.push_back(tail);
    const std::size_t first = chain.size();
    const bool tail_first = std::pair(tail.x(), tail.y()) < std::pair(head.x(), head.y());
    append_inner_points(
        film_arc(tail_first ? arc.arc : reversed(arc.arc)), tail_first ? tail : head, chain);
    if (!tail_first) {
        std::reverse(chain.begin() + static_cast<std::ptrdiff_t>(first), chain.end());
    }
}

// Outlines each bubble and what is around the patch.
class PatchOutliner {
  public:
    explicit PatchOutliner(const PixelPatch& pixels) : pixels_(pixels) {}

    void outline(BubbleId bubble, OutlineBatch& batch) {
        const Boundaries boundaries = boundaries_of(pixels_, bubble);
        std::size_t begin = 0;
        for (const std::size_t end : boundaries.loop_ends) {
            append_loop(std::span(boundaries.arcs).subspan(begin, end - begin), bubble, batch);
            begin = end;
        }
    }

  private:
    void append_loop(std::span<const ArcLoops::Arc> loop, BubbleId bubble, OutlineBatch& batch) {
        if (!may_show(pixels_.grid, loop)) {
            return;
        }
        chain_.clear();
        for (std::size_t k = 0; k < loop.size(); ++k) {
            append_chain(loop[k], loop[(k + 1) % loop.size()].tail, chain_);
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
    std::vector<Vec2> chain_;
};

}  // namespace

CellOutlines outline_patch(const Frame& frame, const RasterGrid& grid, int threads) {
    const PixelPatch pixels{frame, grid, pixels_per_unit(grid, frame.domain)};
    CellOutlines cells = outline_all(grid, region_count(frame), PatchOutliner(pixels), threads);
    cells.outside = frame.network.ghost();
    return cells;
}

}  // namespace foam::texgen
