#include "texgen/raster/torus_cells.h"

#include "texgen/raster/film_shapes.h"
#include "texgen/raster/parallel_for.h"
#include "texgen/raster/vector_clones.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace foam::texgen {

namespace {

constexpr int kSquareBits = 5;     // of pixels
constexpr double kRounding = 2.0;  // subpixels, of both ends of a film and more

std::size_t blocks_of(std::size_t sides) {
    return (sides + SideLanes::kLanes - 1) / SideLanes::kLanes;
}

// What a bubble's extent is made of. An arc reaches beyond its chord by no more than its sagitta,
// half the chord times the tangent of a quarter of its turn, or by a whole diameter.
struct Reach {
    std::int32_t left, right, bottom, top;  // of the tails
    double beyond;                          // the largest of the sides, pixels
};

FOAMTEX_VECTOR_CLONES void extend(const SideLanes& sides, Reach& reach) {
    constexpr double kLeastCosine = 0.2;  // of an arc whose sagitta is asked for
    Reach to = reach;
    for (std::size_t k = 0; k < SideLanes::kLanes; ++k) {
        to.left = std::min(to.left, sides.tail_x[k]);
        to.right = std::max(to.right, sides.tail_x[k]);
        to.bottom = std::min(to.bottom, sides.tail_y[k]);
        to.top = std::max(to.top, sides.tail_y[k]);
        const double length = std::abs(sides.chord_x[k]) + std::abs(sides.chord_y[k]);
        const double sine = std::abs(sides.sine[k]);
        const double cosine = sides.cosine[k];
        const double sagitta = 0.5 * length * sine / (1.0 + cosine);
        const double beyond = cosine > kLeastCosine ? sagitta : length / sine;
        to.beyond = beyond > to.beyond ? beyond : to.beyond;
    }
    reach = to;
}

RegionExtent extent_of(std::span<const SideLanes> sides) {
    const SubpixelPoint first = sides.front().tail(0);
    Reach reach{first.x, first.x, first.y, first.y, 0.0};
    for (const SideLanes& some : sides) {
        extend(some, reach);
    }
    const auto margin = static_cast<std::int32_t>(reach.beyond * kSubpixel + kRounding);
    return {first,
            {reach.left - margin, reach.bottom - margin},
            {reach.right + margin, reach.top + margin}};
}

}  // namespace

TorusCells::TorusCells(const Frame& frame, const RasterGrid& grid, int threads)
    : grid_(grid),
      pixels_(frame, grid_),
      shapes_(film_shapes(frame, pixels_.scale, threads)),
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
    batch.bubbles.reserve(end - begin);
    std::size_t blocks = 0;
    for (std::size_t k = begin; k < end; ++k) {
        const auto sides = static_cast<std::size_t>(pixels_.frame.network.sides(bubbles_[k]));
        batch.bubbles.push_back(
            {static_cast<std::uint32_t>(blocks), static_cast<std::uint32_t>(sides)});
        blocks += blocks_of(sides);
    }
    batch.lanes = std::make_unique_for_overwrite<SideLanes[]>(blocks);
    for (std::size_t from = begin; from < end; from += kTogether) {
        const std::size_t to = std::min(from + kTogether, end);
        gather(from, to, batch);
        for (std::size_t k = from; k < to; ++k) {
            const auto& [first, sides] = batch.bubbles[k - begin];
            extents_[k] = extent_of({&batch.lanes[first], blocks_of(sides)});
        }
    }
}

// What follows a side is known once the side is there, which lies anywhere in memory: around
// several bubbles in step, processors wait for all of them at once.
void TorusCells::gather(std::size_t begin, std::size_t end, Batch& batch) {
    const Network& network = pixels_.frame.network;
    std::array<Walk, kTogether> all;
    const std::span walks = std::span(all).first(end - begin);
    std::size_t most = 0;
    for (std::size_t k = begin; k < end; ++k) {
        const auto& [first, sides] = batch.bubbles[k % kPerTask];
        const HalfEdgeId side = network.first(bubbles_[k]);
        walks[k - begin] = {side, {}, &batch.lanes[first], sides};
        firsts_[k] = pixels_.exact(network.tail(side));
        most = std::max<std::size_t>(most, sides);
    }
    for (std::size_t step = 0; step < most; ++step) {
        for (Walk& walk : walks) {
            if (step < walk.sides) {
                go(step, walk);
            }
        }
    }
    for (const Walk& walk : walks) {
        for (std::size_t k = walk.sides; k % SideLanes::kLanes != 0; ++k) {
            walk.to[k / SideLanes::kLanes].set(k % SideLanes::kLanes, {}, walk.to->tail(0));
        }
    }
}

void TorusCells::go(std::size_t step, Walk& walk) const {
    const Network& network = pixels_.frame.network;
    const HalfEdgeId h = walk.side;
    const LatticeOffset offset = network.offset(forward_side(film_of(h)));
    const int along = static_cast<int>(is_forward(h)) * 2 - 1;  // no branch, as shape_along
    walk.to[step / SideLanes::kLanes].set(
        step % SideLanes::kLanes,
        shape_along(shapes_, h),
        junctions_[index_of(network.tail(h))] + pixels_.translation(walk.lift));
    walk.lift = walk.lift + LatticeOffset{along * offset.i, along * offset.j};
    walk.side = network.next(h);
}

BubbleSides TorusCells::sides(std::size_t bubble) const {
    const Batch& batch = batches_[bubble / kPerTask];
    const auto& [first, count] = batch.bubbles[bubble % kPerTask];
    return {{&batch.lanes[first], blocks_of(count)}, count, firsts_[bubble]};
}

void TorusCells::expect(std::size_t bubble) const {
    constexpr std::size_t kLineBytes = 64;
    const std::span<const std::byte> bytes = std::as_bytes(sides(bubble).lanes.first<1>());
    for (std::size_t k = 0; k < bytes.size(); k += kLineBytes) {
        __builtin_prefetch(&bytes[k]);
    }
}

}  // namespace foam::texgen
