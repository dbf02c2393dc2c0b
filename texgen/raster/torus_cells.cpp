#include "texgen/raster/torus_cells.h"

#include "texgen/raster/half_turns.h"
#include "texgen/raster/parallel_for.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace foam::texgen {

namespace {

constexpr int kSquareBits = 5;     // of pixels
constexpr double kRounding = 2.0;  // subpixels, of both ends of a film and more

// How far an arc reaches beyond its chord, at most: its sagitta, by no less than the tangent of a
// quarter of its turn, or a whole diameter.
double reach(const FilmArc& arc) {
    constexpr double kQuarterTurn = 0.7;
    const double length = std::abs(arc.chord.x()) + std::abs(arc.chord.y());
    const double half = 0.5 * std::abs(arc.half_angle);
    return half < kQuarterTurn ? 0.5 * length * half * (1.0 + 0.5 * half * half)
                               : length / std::sin(2.0 * half);
}

// Of the first sides.
template <class Side>
void turn(std::span<const Side> sides, HalfTurns& turns) {
    const std::size_t count = std::min(sides.size(), HalfTurns::kLanes);
    for (std::size_t k = 0; k < count; ++k) {
        turns.angle[k] = sides[k].arc.half_angle;
    }
    find_turns(turns);
}

template <class Side>
RegionExtent extent_of(std::span<const Side> sides) {
    const SubpixelPoint first = sides.front().tail;
    RegionExtent extent{first, first, first};
    double beyond = 0.0;
    for (const Side& side : sides) {
        const auto& [low, high] = std::pair(extent.lowest, extent.highest);
        extent.lowest = {std::min(low.x, side.tail.x), std::min(low.y, side.tail.y)};
        extent.highest = {std::max(high.x, side.tail.x), std::max(high.y, side.tail.y)};
        beyond = std::max(beyond, reach(side.arc));
    }
    const auto margin = static_cast<std::int32_t>(beyond * kSubpixel + kRounding);
    extent.lowest = extent.lowest - SubpixelPoint{margin, margin};
    extent.highest = extent.highest + SubpixelPoint{margin, margin};
    return extent;
}

}  // namespace

TorusCells::TorusCells(const Frame& frame, const RasterGrid& grid, int threads)
    : grid_(grid),
      pixels_(frame, grid_),
      junctions_(pixels_.junctions()),
      bubbles_(frame.network.bubble_slots()),
      extents_(frame.network.bubble_slots()),
      firsts_(frame.network.bubble_slots()) {
    order_bubbles();
    batches_.resize((bubbles_.size() + kPerTask - 1) / kPerTask);
    parallel_for(
        static_cast<int>(batches_.size()), threads, [&](int task) { gather_bubbles(task); });
}

// By the square that the tail of the first side lies in.
void TorusCells::order_bubbles() {
    const Network& network = pixels_.frame.network;
    const auto square_of = [&](std::int32_t subpixel) {
        return static_cast<std::size_t>(subpixel >> (kSubpixelBits + kSquareBits));
    };
    const std::size_t columns = square_of(grid_.width * kSubpixel) + 1;
    const std::size_t rows = square_of(grid_.height * kSubpixel) + 1;
    std::vector<std::uint32_t> squares(bubbles_.size());
    std::vector<std::uint32_t> ends(columns * rows + 1);
    for (std::size_t k = 0; k < squares.size(); ++k) {
        const JunctionId first = network.tail(network.first(id_at<BubbleId>(k)));
        const SubpixelPoint at = junctions_[index_of(first)];
        squares[k] = static_cast<std::uint32_t>(square_of(at.y) * columns + square_of(at.x));
        ++ends[squares[k] + 1];
    }
    std::partial_sum(ends.begin(), ends.end(), ends.begin());
    for (std::size_t k = 0; k < squares.size(); ++k) {
        bubbles_[ends[squares[k]]++] = id_at<BubbleId>(k);
    }
}

void TorusCells::gather_bubbles(int task) {
    Batch& batch = batches_[static_cast<std::size_t>(task)];
    const std::size_t begin = static_cast<std::size_t>(task) * kPerTask;
    const std::size_t end = std::min(begin + kPerTask, bubbles_.size());
    batch.ends.reserve(end - begin);
    batch.sides.reserve(7 * (end - begin));
    for (std::size_t from = begin; from < end; from += kAhead) {
        const std::size_t to = std::min(from + kAhead, end);
        const Ahead ahead = look_ahead(from, to);
        for (std::size_t k = from; k < to; ++k) {
            gather(k, ahead, batch);
        }
    }
}

// What follows a side is known once the side is there, which lies anywhere in memory: around
// several bubbles in step, processors wait for all of them at once. What else belongs to the sides
// is fetched meanwhile.
TorusCells::Ahead TorusCells::look_ahead(std::size_t begin, std::size_t end) const {
    const Frame& frame = pixels_.frame;
    const Network& network = frame.network;
    Ahead ahead;
    std::array<HalfEdgeId, kAhead> sides{};
    for (std::size_t k = 0; k < end - begin; ++k) {
        sides[k] = network.first(bubbles_[begin + k]);
        __builtin_prefetch(&frame.positions[network.tail(sides[k])]);
    }
    for (std::array<LatticeOffset, kAhead>& offsets : ahead) {
        for (std::size_t k = 0; k < end - begin; ++k) {
            const HalfEdgeId side = sides[k];
            __builtin_prefetch(&frame.arcs[film_of(side)]);
            __builtin_prefetch(&junctions_[index_of(network.tail(side))]);
            offsets[k] = network.offset(side);
            sides[k] = network.next(side);
        }
    }
    return ahead;
}

void TorusCells::gather(std::size_t place, const Ahead& ahead, Batch& batch) {
    const Frame& frame = pixels_.frame;
    const Network& network = frame.network;
    const std::size_t first_side = batch.sides.size();
    const HalfEdgeId first = network.first(bubbles_[place]);
    LatticeOffset lift;
    HalfEdgeId h = first;
    std::size_t step = 0;
    do {
        const SubpixelPoint junction = junctions_[index_of(network.tail(h))];
        batch.sides.push_back({pixels_.arc(h), junction + pixels_.translation(lift)});
        lift = lift + (step < kMostlySides ? ahead[step][place % kAhead] : network.offset(h));
        h = network.next(h);
        ++step;
    } while (h != first);
    batch.ends.push_back(batch.sides.size());
    extents_[place] = extent_of(std::span<const Side>(batch.sides).subspan(first_side));
    firsts_[place] = pixels_.exact(network.tail(first));
}

std::span<const TorusCells::Side> TorusCells::sides_of(std::size_t place) const {
    const Batch& batch = batches_[place / kPerTask];
    const std::size_t k = place % kPerTask;
    const std::size_t begin = k == 0 ? 0 : batch.ends[k - 1];
    return std::span(batch.sides).subspan(begin, batch.ends[k] - begin);
}

// The first point was rounded to a subpixel, which the region's sides are not.
void TorusCells::place(std::size_t bubble,
                       const Place& at,
                       RowCrossings& crossings,
                       CellMask& mask,
                       RegionField& region) const {
    region.clear(RegionField::Kind::Bubble);
    const SubpixelPoint from_corner = at.translation - at.corner;
    const SubpixelPoint from_mask = at.translation - at.mask;
    Vec2 from = firsts_[bubble] + Vec2(from_corner.x, from_corner.y) / kSubpixel;
    const std::span<const Side> sides = sides_of(bubble);
    HalfTurns turns;
    for (std::size_t k = 0; k < sides.size(); ++k) {
        const std::size_t lane = k % HalfTurns::kLanes;
        if (lane == 0) {
            turn(sides.subspan(k), turns);
        }
        const Vec2& ahead = sides[k].arc.chord;
        const double chord = ahead.norm();
        const double cosine = turns.cosine[lane];
        const double sine = turns.sine[lane];
        if (chord > kShortestSide) {
            region.add_side({from + 0.5 * ahead, ahead / chord, chord, cosine, sine});
        }
        from += ahead;
        const SubpixelPoint tail = sides[k].tail + from_mask;
        const SubpixelPoint head = sides[k + 1 < sides.size() ? k + 1 : 0].tail + from_mask;
        crossings.add({tail, head, cosine, sine}, mask);
    }
    crossings.mark(mask);
    region.close_boundary();
}

}  // namespace foam::texgen
