#include "texgen/raster/outlines.h"

#include "core/parallel/parallel_map.h"
#include "texgen/raster/coords/pixel_frame.h"
#include "texgen/raster/flatten.h"
#include "texgen/raster/outline_batch.h"
#include "texgen/raster/patch_outlines.h"

namespace foam::texgen {

namespace {

// The points of a torus' junctions and films, each once. Those of a film are its inner ones,
// relative to the tail of its forward side.
class FilmChains {
  public:
    FilmChains(const PixelFrame& pixels, int threads)
        : junctions_(pixels.junctions(threads)), ends_(pixels.frame.network.film_slots()) {
        const auto place = [&](std::size_t first, std::size_t last) {
            std::vector<SubpixelPoint> points;
            for (std::size_t k = first; k < last; ++k) {
                const HalfEdgeId side = forward_side(id_at<FilmId>(k));
                append_inner_points(pixels.arc(side), Vec2::Zero(), {}, points);
                ends_[k] = points.size();
            }
            return points;
        };
        tasks_ = parallel_map(ends_.size(), kFilmsPerTask, threads, place);
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

}  // namespace

PixelBox box_around(const Outline& outline, SubpixelPoint translation) {
    const SubpixelPoint low = outline.lowest + translation;
    const SubpixelPoint high = outline.highest + translation;
    return {pixel_of(low.x), pixel_of(high.x) + 1, pixel_of(low.y), pixel_of(high.y) + 1};
}

CellOutlines outline_cells(const Frame& frame, const RasterGrid& grid, int threads) {
    if (frame.domain.is_plane()) {
        return outline_patch(frame, grid, threads);
    }
    const PixelFrame pixels(frame, grid);
    const FilmChains chains(pixels, threads);
    const std::size_t bubbles = frame.network.bubble_slots();
    CellOutlines cells = outline_all(grid, bubbles, SharedOutliner(pixels, chains), threads);
    cells.shear = pixels.shear;
    return cells;
}

}  // namespace foam::texgen
