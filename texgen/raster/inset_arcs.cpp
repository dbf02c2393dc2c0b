#include "texgen/raster/inset_arcs.h"

#include "texgen/raster/arc_batch.h"
#include "texgen/raster/arcs/film_shapes.h"
#include "texgen/raster/inset.h"
#include "texgen/raster/plain_insets.h"

#include <algorithm>
#include <array>
#include <span>

namespace foam::texgen {

namespace {

constexpr std::size_t kAtOnce = PlainInsets::kMostBubbles;
constexpr std::size_t kGroupsPerTask = 16;
constexpr std::size_t kMostlyArcs = 8 * kAtOnce * kGroupsPerTask;  // no more of a task, mostly

class InsetArcs {
  public:
    InsetArcs(const PixelFrame& pixels, const std::vector<PixelArc>& shapes, double inset)
        : pixels_(pixels), shapes_(shapes), inset_(inset) {}

    // A group of bubbles.
    void make(std::size_t group, ArcBatch& batch) {
        if (batch.arcs.empty()) {
            batch.arcs.reserve(kMostlyArcs);
        }
        const std::size_t begin = group * kAtOnce;
        const std::size_t end = std::min(begin + kAtOnce, network().bubble_slots());
        look_ahead(begin, end);
        plain_.clear();
        for (std::size_t k = begin; k < end; ++k) {
            add_plain(id_at<BubbleId>(k));
        }
        plain_.trace(inset_);
        std::size_t lanes = 0;
        for (std::size_t k = begin; k < end; ++k) {
            const auto bubble = id_at<BubbleId>(k);
            const bool has_lanes = sides(bubble) <= PlainInsets::kMostSides;
            if (has_lanes && plain_.is_certain(lanes)) {
                append_plain(lanes, bubble, batch);
            } else {
                append_any(bubble, batch);
            }
            lanes += has_lanes ? 1 : 0;
        }
    }

  private:
    const Network& network() const { return pixels_.frame.network; }
    std::size_t sides(BubbleId bubble) const {
        return static_cast<std::size_t>(network().sides(bubble));
    }
    SubpixelPoint anchor(BubbleId bubble) const {
        return pixels_.junction(network().tail(network().first(bubble)));
    }

    // What follows a side is known once the side is there, which lies anywhere in memory: around
    // several bubbles in step, processors wait for all of them at once. What else belongs to the
    // sides is fetched meanwhile.
    void look_ahead(std::size_t begin, std::size_t end) {
        std::array<HalfEdgeId, kAtOnce> at{};
        std::size_t most = 0;
        for (std::size_t k = begin; k < end; ++k) {
            const auto bubble = id_at<BubbleId>(k);
            at[k - begin] = network().first(bubble);
            most = std::max(most, std::min(sides(bubble), PlainInsets::kMostSides));
        }
        for (std::size_t step = 0; step < most; ++step) {
            for (std::size_t k = 0; k < end - begin; ++k) {
                const HalfEdgeId h = at[k];
                ahead_[k][step] = h;
                at[k] = network().next(h);
                __builtin_prefetch(&shapes_[index_of(film_of(h))]);
            }
            for (std::size_t k = 0; step == 0 && k < end - begin; ++k) {
                __builtin_prefetch(&pixels_.frame.positions[network().tail(ahead_[k][0])]);
            }
        }
    }

    void add_plain(BubbleId bubble) {
        const std::array<HalfEdgeId, PlainInsets::kMostSides>& ahead =
            ahead_[index_of(bubble) % kAtOnce];
        if (sides(bubble) <= PlainInsets::kMostSides) {
            plain_.add(sides(bubble),
                       [&](std::size_t k) { return shape_along(shapes_, ahead[k]); });
        }
    }

    void append_plain(std::size_t k, BubbleId bubble, ArcBatch& batch) {
        const SubpixelPoint origin = anchor(bubble);
        const std::size_t begin = batch.arcs.size();
        const ArcSides sides{arc_side(bubble)};
        SubpixelPoint tail = origin + plain_.rounded_tail(plain_.begin(k));
        for (std::size_t lane = plain_.begin(k); lane < plain_.end(k); ++lane) {
            const SubpixelPoint head = origin + plain_.rounded_tail(lane + 1);
            if (plain_.is_monotone(lane)) {
                append_piece(tail, head, plain_.sine(lane), sides, batch.arcs);
            } else {
                append_arc(plain_.arc(lane).arc, tail, head, sides, batch.arcs);
            }
            tail = head;
        }
        drop_if_empty(begin, bubble, batch);
    }

    void append_any(BubbleId bubble, ArcBatch& batch) {
        place_sides(bubble);
        const SubpixelPoint origin = anchor(bubble);
        const ArcLoops& loops = tracer_.trace(sides_, inset_);
        std::size_t begin = 0;
        for (const std::size_t end : loops.loop_ends) {
            append_loop(std::span(loops.arcs).subspan(begin, end - begin), origin, bubble, batch);
            begin = end;
        }
        batch.unresolved += loops.open_ends;
    }

    // Relative to the tail of the first.
    void place_sides(BubbleId bubble) {
        sides_.clear();
        Vec2 at = Vec2::Zero();
        HalfEdgeId h = network().first(bubble);
        do {
            const PixelArc arc = shape_along(shapes_, h);
            if (arc.chord.norm() > kShortestSide) {
                sides_.push_back(place(arc, at));
            }
            at += arc.chord;
            h = network().next(h);
        } while (h != network().first(bubble));
    }

    static void append_loop(std::span<const ArcLoops::Arc> arcs,
                            SubpixelPoint origin,
                            BubbleId bubble,
                            ArcBatch& batch) {
        const std::size_t begin = batch.arcs.size();
        SubpixelPoint tail = origin + to_subpixel(arcs.front().tail);
        for (std::size_t k = 0; k < arcs.size(); ++k) {
            const ArcLoops::Arc& next = arcs[k + 1 < arcs.size() ? k + 1 : 0];
            const SubpixelPoint head = origin + to_subpixel(next.tail);
            append_arc(arcs[k].arc, tail, head, {arc_side(bubble)}, batch.arcs);
            tail = head;
        }
        drop_if_empty(begin, bubble, batch);
    }

    // A loop that is too small for subpixels, or of an invalid bubble.
    static void drop_if_empty(std::size_t begin, BubbleId bubble, ArcBatch& batch) {
        const auto loop = std::span<const CellArc>(batch.arcs).subspan(begin);
        if (!(twice_area(loop, arc_side(bubble)) > 0.0)) {
            batch.arcs.resize(begin);
        }
    }

    const PixelFrame& pixels_;
    const std::vector<PixelArc>& shapes_;
    double inset_;
    std::array<std::array<HalfEdgeId, PlainInsets::kMostSides>, kAtOnce> ahead_{};
    std::vector<SideArc> sides_;
    PlainInsets plain_;
    InsetTracer tracer_;
};

}  // namespace

CellArcs inset_arcs(const PixelFrame& pixels,
                    const std::vector<PixelArc>& shapes,
                    double inset,
                    int threads) {
    const InsetArcs insets(pixels, shapes, inset);
    const std::size_t bubbles = pixels.frame.network.bubble_slots();
    return make_arcs(
        pixels.grid, (bubbles + kAtOnce - 1) / kAtOnce, kGroupsPerTask, insets, threads);
}

}  // namespace foam::texgen
