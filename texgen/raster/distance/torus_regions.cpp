// SPDX-License-Identifier: Apache-2.0

#include "texgen/raster/distance/torus_regions.h"

#include "core/parallel/parallel_for.h"
#include "texgen/raster/arcs/film_arcs.h"

#include <algorithm>
#include <numeric>

// The sides of a bubble are read in a traversal of half-edges (D. E. Muller and F. P. Preparata,
// "Finding the intersection of two convex polyhedra", 1978). In the order of the simulation, each
// side would be a random access to memory, unless the foam was numbered along a curve
// (core/foam/spatial_order). Therefore the data of films and the order of bubbles are both sorted
// by position, a reordering of data and of computation as by J. Mellor-Crummey, D. Whalley and K.
// Kennedy ("Improving memory hierarchy performance for irregular applications using data and
// computation reorderings", 2001). They order along space-filling curves; for an image that is
// drawn in bands of rows, rows of squares suffice. The sum of the lattice offsets of the sides
// unwraps a boundary that crosses the border of the torus.

namespace foam::texgen {

namespace {

constexpr std::size_t kPerTask = 2048;  // films or bubbles
// While a film is read, the film that is this many elements after it in films_ is prefetched.
// Bubbles and films are sorted by the same squares, so one of the next bubbles needs this film.
// Processors do not prefetch it themselves, because they cannot predict the order in which the
// films of a square are read. The last film is followed by as many unused films, so that every
// prefetched film exists.
constexpr std::size_t kFilmsAhead = 96;

SubpixelPoint whole(const Vec2& subpixels) {
    return {static_cast<std::int32_t>(subpixels.x()), static_cast<std::int32_t>(subpixels.y())};
}

Vec2 real(SubpixelPoint point) {
    return Vec2(point.x, point.y);
}

// The grid is divided into squares of TorusRegions::kSquare pixels per side. Returns the row or
// column of the square that contains a coordinate in subpixels. `pixels` is the height or width of
// the grid. A coordinate on the upper or right border of the grid belongs to the first square,
// which contains its periodic copy.
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
      new_index_(frame.network.film_slots()),
      films_(sorted_films(threads)),
      starts_(sorted_starts(threads)) {}

// Sorts items by the square of the grid that contains them. position(item) is the position of an
// item in subpixels.
template <class Item, class PositionOf>
Buckets<Item> TorusRegions::sorted(std::span<const Item> items,
                                   int threads,
                                   const PositionOf& position) const {
    constexpr std::size_t kPerPart = 8192;
    const RasterGrid& grid = pixels_.grid;
    const std::size_t squares = columns_ * squares_along(grid.height);
    const std::size_t parts = (items.size() + kPerPart - 1) / kPerPart;
    return counting_sort<Item>(squares, parts, threads, [&](std::size_t part, const auto& put) {
        const std::size_t first = part * kPerPart;
        const std::size_t count = std::min(kPerPart, items.size() - first);
        for (const Item& item : items.subspan(first, count)) {
            const SubpixelPoint at = position(item);
            put(square_of(at.y, grid.height) * columns_ + square_of(at.x, grid.width), item);
        }
    });
}

std::vector<TorusRegions::Film> TorusRegions::sorted_films(int threads) {
    const Network& network = pixels_.frame.network;
    const std::vector<PixelArc> arcs = film_arcs(pixels_.frame, pixels_.scale, threads);
    std::vector<std::uint32_t> order(arcs.size());
    std::iota(order.begin(), order.end(), 0U);
    order = sorted<std::uint32_t>(order, threads, [&](std::uint32_t film) {
                return pixels_.rounded_position(network.tail(forward_side(id_at<FilmId>(film))));
            }).items;
    for (std::size_t k = 0; k < order.size(); ++k) {
        new_index_[order[k]] = static_cast<std::uint32_t>(k);
    }
    std::vector<Film> films(order.size() + kFilmsAhead);
    parallel_for(order.size(), kPerTask, threads, [&](std::size_t first, std::size_t last) {
        Film* const to = films.data();  // a pointer, as in trace()
        for (std::size_t k = first; k < last; ++k) {
            const HalfEdgeId forward = forward_side(id_at<FilmId>(k));
            to[new_index_[k]] = {
                arcs[k],
                {pixels_.rounded_position(network.tail(forward)),
                 pixels_.rounded_position(network.head(forward))},
                {side_of(network.next(forward)), side_of(network.next(twin(forward)))},
                pixels_.translation(network.offset(forward))};
        }
    });
    return films;
}

Buckets<TorusRegions::Start> TorusRegions::sorted_starts(int threads) const {
    const Network& network = pixels_.frame.network;
    std::vector<Start> starts(network.bubble_slots());
    parallel_for(starts.size(), kPerTask, threads, [&](std::size_t first, std::size_t last) {
        for (std::size_t k = first; k < last; ++k) {
            const HalfEdgeId side = network.first(id_at<BubbleId>(k));
            const JunctionId tail = network.tail(side);
            starts[k] = {static_cast<std::uint32_t>(k),
                         side_of(side),
                         pixels_.rounded_position(tail),
                         pixels_.exact_position(tail)};
        }
    });
    return sorted<Start>(starts, threads, [](const Start& start) { return start.from; });
}

std::span<const TorusRegions::Start> TorusRegions::starts(int first, int rows) const {
    const std::size_t all = squares_along(pixels_.grid.height);
    const auto begin = static_cast<std::size_t>(first / kSquare);
    const std::size_t end = std::min(begin + static_cast<std::size_t>(rows / kSquare), all);
    return starts_.items_of(begin * columns_, end * columns_);
}

// The arc of a film is stored for its forward side. For the other side, its chord, sine and offset
// are negated. A factor of 1 or -1 replaces an unpredictable branch on the direction of the side.
void TorusRegions::trace(const Start& start, Region& region) const {
    region.id = start.bubble;
    region.first = start.from;
    region.boundary.clear();
    Vec2 tail = start.tail;
    SubpixelPoint unwrapping;  // from a tail in the fundamental cell to its unwrapped position
    Side side = start.side;
    // A pointer, because std::vector checks indices in hardened builds.
    const Film* const films = films_.data();
    do {
        const Film& film = films[side / 2];
        __builtin_prefetch(&film + kFilmsAhead);
        const std::size_t end = side % 2;
        const int along = 1 - 2 * static_cast<int>(end);
        const PixelArc shape{along * film.arc.chord, film.arc.cosine, along * film.arc.sine};
        const SubpixelPoint from = film.tail[end] + unwrapping;
        unwrapping = unwrapping + SubpixelPoint{along * film.offset.x, along * film.offset.y};
        const SubpixelPoint to = film.tail[1 - end] + unwrapping;
        region.boundary.add_arc(shape, tail);
        region.boundary.add_edge({real(from), real(to), shape.cosine, shape.sine});
        tail += shape.chord;
        side = film.next[end];
    } while (side != start.side);
    region.boundary.close_loop();
    const Extent extent = region.boundary.extent();
    region.lowest = whole(extent.lowest);
    region.highest = whole(extent.highest);
}

}  // namespace foam::texgen
