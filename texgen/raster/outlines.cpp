#include "texgen/raster/outlines.h"

#include "texgen/raster/flatten.h"
#include "texgen/raster/inset.h"
#include "texgen/raster/parallel_for.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace foam::texgen {

namespace {

constexpr std::size_t kBubblesPerTask = 256;
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

// What one task makes.
struct Batch {
    std::vector<Outline> outlines;
    std::vector<SubpixelPoint> points;
    int unresolved = 0;
};

bool is_counter_clockwise(std::span<const SubpixelPoint> chain) {
    std::int64_t twice_area = 0;
    SubpixelPoint a = chain.back() - chain.front();
    for (const SubpixelPoint point : chain) {
        const SubpixelPoint b = point - chain.front();
        twice_area += std::int64_t{a.x} * b.y - std::int64_t{a.y} * b.x;
        a = b;
    }
    return twice_area > 0;
}

// Takes the points from first_point on as an outline of the bubble.
void close_outline(Batch& batch, BubbleId bubble, std::size_t first_point) {
    const auto chain = std::span<const SubpixelPoint>(batch.points).subspan(first_point);
    const auto [low, high] = std::minmax_element(
        chain.begin(), chain.end(), [](SubpixelPoint a, SubpixelPoint b) { return a.y < b.y; });
    batch.outlines.push_back({bubble, 0, first_point, chain.size(), low->y, high->y});
}

// The inner points of all films, each relative to the tail of its forward side.
class FilmChains {
  public:
    explicit FilmChains(const PixelFrame& pixels) {
        ends_.reserve(pixels.frame.network.film_slots());
        for (const FilmId film : pixels.frame.network.films()) {
            append_inner_points(pixels.arc(forward_side(film)), Vec2::Zero(), {}, points_);
            ends_.push_back(points_.size());
        }
    }

    std::span<const SubpixelPoint> of(FilmId film) const {
        const std::size_t begin = index_of(film) == 0 ? 0 : ends_[index_of(film) - 1];
        return std::span(points_).subspan(begin, ends_[index_of(film)] - begin);
    }

  private:
    std::vector<SubpixelPoint> points_;
    std::vector<std::size_t> ends_;
};

// Outlines of bubbles whose films have no width: the films' own chains, the same on both sides.
class SharedOutliner {
  public:
    SharedOutliner(const PixelFrame& pixels, const FilmChains& chains)
        : pixels_(pixels), chains_(chains) {}

    void outline(BubbleId bubble, Batch& batch) const {
        const Network& network = pixels_.frame.network;
        const std::size_t first_point = batch.points.size();
        LatticeOffset lift;
        for (const HalfEdgeId h : network.around(bubble)) {
            const SubpixelPoint tail = lifted(network.tail(h), lift);
            lift = lift + network.offset(h);
            batch.points.push_back(tail);
            append_side(h, tail, lifted(network.head(h), lift), batch.points);
        }
        close_outline(batch, bubble, first_point);
    }

  private:
    SubpixelPoint lifted(JunctionId junction, LatticeOffset lift) const {
        return pixels_.junction(junction) + pixels_.translation(lift);
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

    void outline(BubbleId bubble, Batch& batch) {
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
                            Batch& batch) {
        const std::size_t first_point = batch.points.size();
        for (const ArcLoops::Arc& arc : arcs) {
            batch.points.push_back(anchor + to_subpixel(arc.tail));
            append_inner_points(arc.arc, arc.tail, anchor, batch.points);
        }
        if (is_counter_clockwise(std::span(batch.points).subspan(first_point))) {
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

CellOutlines gather(const PixelFrame& pixels, std::vector<Batch>& batches) {
    CellOutlines cells{pixels.grid, pixels.shear, {}, {}, 0};
    for (Batch& batch : batches) {
        for (Outline& outline : batch.outlines) {
            outline.batch = cells.batches.size();
        }
        cells.outlines.insert(cells.outlines.end(), batch.outlines.begin(), batch.outlines.end());
        cells.batches.push_back(std::move(batch.points));
        cells.unresolved += batch.unresolved;
    }
    return cells;
}

// Gives every task its own copy of the outliner.
template <class Outliner>
CellOutlines outline_all(const PixelFrame& pixels, const Outliner& outliner, int threads) {
    const std::size_t bubbles = pixels.frame.network.bubble_slots();
    std::vector<Batch> batches((bubbles + kBubblesPerTask - 1) / kBubblesPerTask);
    parallel_for(static_cast<int>(batches.size()), threads, [&](int task) {
        Outliner own = outliner;
        const std::size_t begin = static_cast<std::size_t>(task) * kBubblesPerTask;
        for (std::size_t k = begin; k < std::min(begin + kBubblesPerTask, bubbles); ++k) {
            own.outline(id_at<BubbleId>(k), batches[static_cast<std::size_t>(task)]);
        }
    });
    return gather(pixels, batches);
}

}  // namespace

CellOutlines outline_cells(const Frame& frame,
                           const RasterGrid& grid,
                           double film_width,
                           int threads) {
    if (!(film_width >= 0.0) || !std::isfinite(film_width)) {
        throw std::invalid_argument("film width must be 0 or more");
    }
    const PixelFrame pixels{
        frame, grid, pixels_per_unit(grid, frame.torus), shear_in_subpixels(grid, frame.torus)};
    if (film_width == 0.0) {
        const FilmChains chains(pixels);
        return outline_all(pixels, SharedOutliner(pixels, chains), threads);
    }
    return outline_all(pixels, InsetOutliner(pixels, film_width), threads);
}

}  // namespace foam::texgen
