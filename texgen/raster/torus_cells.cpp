#include "texgen/raster/torus_cells.h"

#include "core/parallel/parallel_for.h"

#include <algorithm>
#include <vector>

namespace foam::texgen {

namespace {

constexpr int kSquare = 32;  // pixels
constexpr std::size_t kSquaresPerBand = TorusCells::kBandRows / kSquare;
constexpr std::size_t kBubblesPerPart = 2048;

std::size_t squares_along(int pixels) {
    return static_cast<std::size_t>((pixels - 1) / kSquare) + 1;
}

// A place at the far border counts to the first square, where its copy is.
std::size_t square_of(std::int32_t place, int pixels) {
    const int pixel = pixel_of(place);
    return static_cast<std::size_t>(pixel < pixels ? pixel / kSquare : 0);
}

}  // namespace

TorusCells::TorusCells(const Frame& frame, const RasterGrid& grid, int threads)
    : grid_(grid),
      pixels_(frame, grid_),
      square_columns_(squares_along(grid_.width)),
      junctions_(pixels_.junctions(threads)),
      films_(film_steps(pixels_, junctions_, threads)),
      bubbles_(ordered_bubbles(threads)) {}

Buckets<TorusBubble> TorusCells::ordered_bubbles(int threads) const {
    std::vector<Start> starts(pixels_.frame.network.bubble_slots());
    const std::size_t parts = (starts.size() + kBubblesPerPart - 1) / kBubblesPerPart;
    const auto of_part = [&](std::size_t part) {
        const std::size_t begin = part * kBubblesPerPart;
        return std::span(starts).subspan(begin, std::min(kBubblesPerPart, starts.size() - begin));
    };
    parallel_for(starts.size(), kBubblesPerPart, threads, [&](std::size_t first, std::size_t last) {
        find_starts(first, std::span(starts).subspan(first, last - first));
    });
    const std::size_t squares = square_columns_ * squares_along(grid_.height);
    return counting_sort<TorusBubble>(
        squares, parts, threads, [&](std::size_t part, const auto& put) {
            for (const Start& start : of_part(part)) {
                put(start.square, start.bubble);
            }
        });
}

// In short loops, so that processors ask for many junctions before the first one is there.
void TorusCells::find_starts(std::size_t first, std::span<Start> starts) const {
    const Network& network = pixels_.frame.network;
    std::vector<JunctionId> tails(starts.size());
    for (std::size_t k = 0; k < starts.size(); ++k) {
        tails[k] = network.tail(network.first(id_at<BubbleId>(first + k)));
    }
    for (std::size_t k = 0; k < starts.size(); ++k) {
        const SubpixelPoint at = junctions_[index_of(tails[k])];
        starts[k].square =
            square_of(at.y, grid_.height) * square_columns_ + square_of(at.x, grid_.width);
    }
    for (std::size_t k = 0; k < starts.size(); ++k) {
        const auto bubble = id_at<BubbleId>(first + k);
        starts[k].bubble = {bubble,
                            network.first(bubble),
                            static_cast<std::uint32_t>(network.sides(bubble)),
                            pixels_.exact(tails[k])};
    }
}

std::span<const TorusBubble> TorusCells::bubbles(int band) const {
    const std::size_t squares = bubbles_.ends.size() - 1;
    const std::size_t of_band = square_columns_ * kSquaresPerBand;
    const std::size_t first = static_cast<std::size_t>(band) * of_band;
    return bubbles_.of(first, std::min(first + of_band, squares));
}

}  // namespace foam::texgen
