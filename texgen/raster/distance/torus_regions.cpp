// SPDX-License-Identifier: Apache-2.0

#include "texgen/raster/distance/torus_regions.h"

#include "core/parallel/parallel_for.h"
#include "texgen/raster/arcs/film_arcs.h"

#include <algorithm>

namespace foam::texgen {

namespace {

// The films around a bubble are not contiguous in memory, so tracing one bubble stalls on a cache
// miss at every side. Up to 16 bubbles are therefore traced in lockstep: the next film of each
// bubble is prefetched while the others advance. The data of a film, including the next side, fit
// into one cache line. Bubbles are sorted by squares of the grid, so that bubbles that are traced
// together write pixels that are close together.

constexpr std::size_t kStartsPerTask = 2048;

SubpixelPoint whole(const Vec2& subpixels) {
    return {static_cast<std::int32_t>(subpixels.x()), static_cast<std::int32_t>(subpixels.y())};
}

Vec2 real(SubpixelPoint point) {
    return Vec2(point.x, point.y);
}

// Returns the row or column of the square that contains a coordinate in subpixels. `pixels` is the
// height or width of the grid. A coordinate on the upper or right border of the grid belongs to the
// first square, which contains its periodic copy.
std::size_t square_of(std::int32_t position, int pixels) {
    const int pixel = pixel_of(position);
    return static_cast<std::size_t>(pixel < pixels ? pixel / TorusRegions::kSquare : 0);
}

std::size_t squares_along(int pixels) {
    return static_cast<std::size_t>((pixels - 1) / TorusRegions::kSquare) + 1;
}

}  // namespace

TorusRegions::TorusRegions(const Frame& frame, const RasterGrid& grid, int threads)
    : pixels_(frame, grid),
      columns_(squares_along(grid.width)),
      junctions_(pixels_.rounded_positions(threads)),
      films_(films(threads)),
      starts_(sorted_starts(threads)) {}

std::unique_ptr<TorusRegions::Film[]> TorusRegions::films(int threads) const {
    const Network& network = pixels_.frame.network;
    auto films = std::make_unique_for_overwrite<Film[]>(network.film_slots());
    for_each_film_arc(
        pixels_.frame, pixels_.scale, threads, [&](std::size_t k, const PixelArc& shape) {
            const HalfEdgeId forward = forward_side(id_at<FilmId>(k));
            const HalfEdgeId other = twin(forward);
            const SubpixelPoint tail = junctions_[index_of(network.tail(forward))];
            const SubpixelPoint head = junctions_[index_of(network.tail(other))];
            const SubpixelPoint offset = pixels_.translation(network.offset(forward));
            films[k] = {shape.chord.x(),
                        shape.chord.y(),
                        shape.cosine,
                        shape.sine,
                        {tail.x, head.x},
                        {tail.y, head.y},
                        {network.next(forward), network.next(other)},
                        offset.x,
                        offset.y};
        });
    return films;
}

// Returns the starts of all bubbles, sorted by squares. Each chunk has two short loops instead of a
// long one, so that the processor overlaps the cache misses of successive iterations.
Buckets<TorusRegions::Start> TorusRegions::sorted_starts(int threads) const {
    const Network& network = pixels_.frame.network;
    const RasterGrid& grid = pixels_.grid;
    std::vector<Start> starts(network.bubble_slots());
    std::vector<JunctionId> tails(starts.size());
    parallel_for(starts.size(), kStartsPerTask, threads, [&](std::size_t first, std::size_t last) {
        for (std::size_t k = first; k < last; ++k) {
            tails[k] = network.tail(network.first(id_at<BubbleId>(k)));
        }
        for (std::size_t k = first; k < last; ++k) {
            starts[k] = {static_cast<std::uint32_t>(k),
                         network.first(id_at<BubbleId>(k)),
                         junctions_[index_of(tails[k])],
                         pixels_.exact_position(tails[k])};
        }
    });
    const std::size_t parts = (starts.size() + kStartsPerTask - 1) / kStartsPerTask;
    const auto visit = [&](std::size_t part, const auto& put) {
        const std::size_t end = std::min((part + 1) * kStartsPerTask, starts.size());
        for (std::size_t k = part * kStartsPerTask; k < end; ++k) {
            const SubpixelPoint at = starts[k].from;
            put(square_of(at.y, grid.height) * columns_ + square_of(at.x, grid.width), starts[k]);
        }
    };
    return counting_sort<Start>(columns_ * squares_along(grid.height), parts, threads, visit);
}

std::span<const TorusRegions::Start> TorusRegions::starts(int first, int rows) const {
    const std::size_t all = squares_along(pixels_.grid.height);
    const auto begin = static_cast<std::size_t>(first / kSquare);
    const std::size_t end = std::min(begin + static_cast<std::size_t>(rows / kSquare), all);
    return starts_.items_of(begin * columns_, end * columns_);
}

// Adds the next side of a bubble to its boundary, and prefetches the side after it.
inline void TorusRegions::advance(Traversal& traversal) const {
    const Film& film = films_[index_of(film_of(traversal.side))];
    const std::size_t end = index_of(traversal.side) % 2;
    const int along = 1 - 2 * static_cast<int>(end);  // a branch would be unpredictable
    const PixelArc shape{
        {along * film.chord_x, along * film.chord_y}, film.cosine, along * film.sine};
    const SubpixelPoint from =
        SubpixelPoint{film.tail_x[end], film.tail_y[end]} + traversal.unwrapping;
    traversal.unwrapping =
        traversal.unwrapping + SubpixelPoint{along * film.offset_x, along * film.offset_y};
    const SubpixelPoint to =
        SubpixelPoint{film.tail_x[1 - end], film.tail_y[1 - end]} + traversal.unwrapping;
    traversal.side = film.next[end];
    __builtin_prefetch(&films_[index_of(film_of(traversal.side))]);
    traversal.boundary->add_arc(shape, traversal.tail);
    traversal.boundary->add_edge(real(from), real(to), shape.cosine, shape.sine);
    traversal.tail += shape.chord;
}

void TorusRegions::trace(std::span<const Start> starts, std::span<Region> regions) const {
    std::array<Traversal, kGroupSize> traversals;
    for (std::size_t k = 0; k < starts.size(); ++k) {
        const Start& start = starts[k];
        __builtin_prefetch(&films_[index_of(film_of(start.side))]);
        regions[k].boundary.clear();
        traversals[k] = {start.side, start.side, start.tail, {}, &regions[k].boundary};
    }
    for (std::size_t count = starts.size(); count > 0;) {
        for (std::size_t k = 0; k < count;) {
            advance(traversals[k]);
            if (traversals[k].side == traversals[k].first) {
                traversals[k] = traversals[--count];
            } else {
                ++k;
            }
        }
    }
    for (std::size_t k = 0; k < starts.size(); ++k) {
        Region& region = regions[k];
        region.boundary.close_loop();
        const Extent extent = region.boundary.extent();
        region.id = starts[k].bubble;
        region.first = starts[k].from;
        region.lowest = whole(extent.lowest);
        region.highest = whole(extent.highest);
    }
}

}  // namespace foam::texgen
