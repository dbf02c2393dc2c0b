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

// How far an arc reaches beyond its chord, at most: its sagitta, or a whole diameter.
double reach(const Vec2& chord, double cosine, double sine) {
    const double length = std::abs(chord.x()) + std::abs(chord.y());
    const double side = std::abs(sine);
    return cosine >= 0.0 ? 0.5 * length * side / (1.0 + cosine) : length / side;
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
        beyond = std::max(beyond, reach(side.shape.chord, side.shape.cosine, side.shape.sine));
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
      shapes_(frame.network.film_slots()),
      bubbles_(frame.network.bubble_slots()),
      extents_(frame.network.bubble_slots()) {
    junctions_.reserve(frame.positions.size());
    for (const Vec2& position : frame.positions) {
        junctions_.push_back(snap(grid_, frame.torus, position));
    }
    order_bubbles();
    const auto tasks = [](std::size_t things) {
        return static_cast<int>((things + kPerTask - 1) / kPerTask);
    };
    batches_.resize(static_cast<std::size_t>(tasks(bubbles_.size())));
    parallel_for(tasks(shapes_.size()), threads, [&](int task) { shape_films(task); });
    parallel_for(tasks(bubbles_.size()), threads, [&](int task) { gather_bubbles(task); });
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

void TorusCells::shape_films(int task) {
    const std::size_t begin = static_cast<std::size_t>(task) * kPerTask;
    const std::size_t end = std::min(begin + kPerTask, shapes_.size());
    for (std::size_t k = begin; k < end; k += HalfTurns::kLanes) {
        const std::size_t count = std::min(HalfTurns::kLanes, end - k);
        HalfTurns turns;
        for (std::size_t lane = 0; lane < count; ++lane) {
            turns.angle[lane] = pixels_.frame.arcs[id_at<FilmId>(k + lane)].half_angle;
        }
        find_turns(turns);
        for (std::size_t lane = 0; lane < count; ++lane) {
            shapes_[k + lane] = {pixels_.scale * pixels_.frame.arcs[id_at<FilmId>(k + lane)].chord,
                                 turns.cosine[lane],
                                 turns.sine[lane]};
        }
    }
}

void TorusCells::gather_bubbles(int task) {
    const Network& network = pixels_.frame.network;
    Batch& batch = batches_[static_cast<std::size_t>(task)];
    const std::size_t begin = static_cast<std::size_t>(task) * kPerTask;
    const std::size_t end = std::min(begin + kPerTask, bubbles_.size());
    batch.ends.reserve(end - begin);
    batch.sides.reserve(7 * (end - begin));
    for (std::size_t k = begin; k < end; ++k) {
        const std::size_t first_side = batch.sides.size();
        const HalfEdgeId first = network.first(bubbles_[k]);
        LatticeOffset lift;
        HalfEdgeId h = first;
        do {
            const SubpixelPoint junction = junctions_[index_of(network.tail(h))];
            batch.sides.push_back({shapes_[index_of(film_of(h))],
                                   junction + pixels_.translation(lift),
                                   is_forward(h)});
            lift = lift + network.offset(h);
            h = network.next(h);
        } while (h != first);
        batch.ends.push_back(batch.sides.size());
        extents_[k] = extent_of(std::span<const Side>(batch.sides).subspan(first_side));
    }
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
    const Network& network = pixels_.frame.network;
    const SubpixelPoint from_corner = at.translation - at.corner;
    const SubpixelPoint from_mask = at.translation - at.mask;
    Vec2 from = pixels_.exact(network.tail(network.first(bubbles_[bubble]))) +
                Vec2(from_corner.x, from_corner.y) / kSubpixel;
    const std::span<const Side> sides = sides_of(bubble);
    for (std::size_t k = 0; k < sides.size(); ++k) {
        const Side& side = sides[k];
        const Shape& shape = side.shape;
        const double sign = side.is_forward ? 1.0 : -1.0;
        const double chord = shape.chord.norm();
        const Vec2 ahead = sign * shape.chord;
        if (chord > kShortestSide) {
            region.add_side(
                {from + 0.5 * ahead, ahead / chord, chord, shape.cosine, sign * shape.sine});
        }
        from += ahead;
        const SubpixelPoint tail = side.tail + from_mask;
        const SubpixelPoint head = sides[k + 1 < sides.size() ? k + 1 : 0].tail + from_mask;
        crossings.add(side.is_forward ? SnappedArc{tail, head, shape.cosine, shape.sine}
                                      : SnappedArc{head, tail, shape.cosine, shape.sine},
                      mask);
    }
    crossings.mark(mask);
    region.close_boundary();
}

}  // namespace foam::texgen
