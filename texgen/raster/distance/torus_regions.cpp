#include "texgen/raster/distance/torus_regions.h"

#include "core/parallel/counting_sort.h"
#include "core/parallel/parallel_for.h"
#include "texgen/raster/arcs/film_shapes.h"

#include <algorithm>

namespace foam::texgen {

namespace {

constexpr std::size_t kItemsPerTask = 2048;
constexpr int kSquare = 32;  // pixels

SubpixelPoint whole(const Vec2& subpixels) {
    return {static_cast<std::int32_t>(subpixels.x()), static_cast<std::int32_t>(subpixels.y())};
}

Vec2 real(SubpixelPoint point) {
    return Vec2(point.x, point.y);
}

// Returns the row or column of the square that holds a position. A position at the far border
// belongs to the first square, where its copy is.
std::size_t square_of(std::int32_t position, int pixels) {
    const int pixel = pixel_of(position);
    return static_cast<std::size_t>(pixel < pixels ? pixel / kSquare : 0);
}

std::size_t squares_along(int pixels) {
    return static_cast<std::size_t>((pixels - 1) / kSquare) + 1;
}

}  // namespace

TorusRegions::TorusRegions(const Frame& frame, const RasterGrid& grid, int threads)
    : pixels_(frame, grid), junctions_(pixels_.junctions(threads)) {
    place_films(threads);
    place_bubbles(threads);
}

// Returns the indices of items, sorted by the square that holds the junction where an item begins.
std::vector<std::uint32_t> TorusRegions::sorted(const std::vector<JunctionId>& begins,
                                                int threads) const {
    const RasterGrid& grid = pixels_.grid;
    const std::size_t columns = squares_along(grid.width);
    const std::size_t squares = columns * squares_along(grid.height);
    const std::size_t parts = (begins.size() + kItemsPerTask - 1) / kItemsPerTask;
    const auto visit = [&](std::size_t part, const auto& put) {
        const std::size_t end = std::min((part + 1) * kItemsPerTask, begins.size());
        for (std::size_t k = part * kItemsPerTask; k < end; ++k) {
            const SubpixelPoint at = junctions_[index_of(begins[k])];
            put(square_of(at.y, grid.height) * columns + square_of(at.x, grid.width),
                static_cast<std::uint32_t>(k));
        }
    };
    return counting_sort<std::uint32_t>(squares, parts, threads, visit).items;
}

void TorusRegions::place_films(int threads) {
    const Network& network = pixels_.frame.network;
    std::vector<JunctionId> begins(network.film_slots());
    for (std::size_t k = 0; k < begins.size(); ++k) {
        begins[k] = network.tail(forward_side(id_at<FilmId>(k)));
    }
    const std::vector<std::uint32_t> order = sorted(begins, threads);
    positions_.resize(order.size());
    for (std::size_t k = 0; k < order.size(); ++k) {
        positions_[order[k]] = static_cast<std::uint32_t>(k);
    }
    films_.resize(order.size());
    shape_films(pixels_.frame, pixels_.scale, threads, [&](std::size_t k, const PixelArc& shape) {
        const HalfEdgeId forward = forward_side(id_at<FilmId>(k));
        const HalfEdgeId other = twin(forward);
        films_[positions_[k]] = {shape,
                                 {junctions_[index_of(network.tail(forward))],
                                  junctions_[index_of(network.tail(other))]},
                                 {side_of(network.next(forward)), side_of(network.next(other))},
                                 pixels_.translation(network.offset(forward))};
    });
}

void TorusRegions::place_bubbles(int threads) {
    const Network& network = pixels_.frame.network;
    std::vector<JunctionId> begins(network.bubble_slots());
    for (std::size_t k = 0; k < begins.size(); ++k) {
        begins[k] = network.tail(network.first(id_at<BubbleId>(k)));
    }
    const std::vector<std::uint32_t> order = sorted(begins, threads);
    starts_.resize(order.size());
    regions_.resize(order.size());
    parallel_for(order.size(), kItemsPerTask, threads, [&](std::size_t first, std::size_t last) {
        // A loop of its own, so that the processor overlaps its cache misses.
        for (std::size_t k = first; k < last; ++k) {
            starts_[k] = {side_of(network.first(id_at<BubbleId>(order[k]))),
                          pixels_.exact(begins[order[k]])};
        }
        Boundary boundary;
        for (std::size_t k = first; k < last; ++k) {
            boundary.clear();
            trace(k, {}, boundary);
            const Extent extent = extent_of(boundary);
            regions_[k] = {order[k],
                           RegionKind::Bubble,
                           whole(boundary.sides.front().from),
                           whole(extent.lowest),
                           whole(extent.highest)};
        }
    });
}

void TorusRegions::trace(std::size_t region, SubpixelPoint offset, Boundary& boundary) const {
    const Start& start = starts_[region];
    Vec2 tail = start.tail + real(offset) / kSubpixel;
    SubpixelPoint lift = offset;
    std::uint32_t side = start.side;
    do {
        const Film& film = films_[side / 2];
        const std::size_t end = side % 2;
        const int along = 1 - 2 * static_cast<int>(end);  // no branch: the side is unpredictable
        const PixelArc shape{along * film.shape.chord, film.shape.cosine, along * film.shape.sine};
        const SubpixelPoint from = film.tails[end] + lift;
        lift = lift + SubpixelPoint{along * film.lift.x, along * film.lift.y};
        boundary.sides.push_back({shape, tail, real(from), real(film.tails[1 - end] + lift)});
        tail += shape.chord;
        side = film.next[end];
    } while (side != start.side);
    boundary.close_loop();
}

}  // namespace foam::texgen
