// SPDX-License-Identifier: Apache-2.0

#include "core/foam/spatial_order.h"

#include "core/foam/corners.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>

// The curve of D. Hilbert ("Ueber die stetige Abbildung einer Linie auf ein Flächenstück", 1891)
// visits the four quarters of a square one after another, and the quarters of each quarter in the
// same way. Points that are close together on the curve are therefore close together in the square.
// J. Mellor-Crummey, D. Whalley and K. Kennedy ("Improving memory hierarchy performance for
// irregular applications using data and computation reorderings", 2001) number particles and the
// nodes of meshes along it.

namespace foam {

namespace {

constexpr int kLevels = 16;  // the curve passes through 2^16 x 2^16 points of a grid

// Returns the position along the curve of a point of the grid. The curve begins at (0, 0) and ends
// at (2^16 - 1, 0). Within the lower left quarter, it is mirrored at the diagonal, and within the
// lower right quarter at the other diagonal, so that the parts join.
std::uint32_t position_on_curve(std::uint32_t x, std::uint32_t y) {
    constexpr std::uint32_t kLast = (1U << kLevels) - 1U;
    std::uint32_t position = 0;
    for (int level = kLevels - 1; level >= 0; --level) {
        const std::uint32_t right = x >> level & 1U;
        const std::uint32_t upper = y >> level & 1U;
        position = 4U * position + (upper == 1U ? 1U + right : 3U * right);
        if (upper == 0U) {
            if (right == 1U) {
                x = kLast - x;
                y = kLast - y;
            }
            std::swap(x, y);
        }
    }
    return position;
}

// Returns the position along the curve of each junction. The curve fills the smallest square that
// contains all junctions.
Indexed<JunctionId, std::uint32_t> positions_on_curve(const Foam& foam) {
    const Box box = box_around_junctions(foam);
    const double side = box.size().maxCoeff();
    const double scale = side > 0.0 ? ((1U << kLevels) - 1U) / side : 0.0;
    Indexed<JunctionId, std::uint32_t> on_curve(foam.network.junction_slots(), 0);
    for (const JunctionId junction : foam.network.junctions()) {
        const Vec2 on_grid = scale * (foam.positions[junction] - box.low);
        on_curve[junction] = position_on_curve(static_cast<std::uint32_t>(on_grid.x()),
                                               static_cast<std::uint32_t>(on_grid.y()));
    }
    return on_curve;
}

}  // namespace

void sort_along_curve(Foam& foam) {
    const Network& network = foam.network;
    const Indexed<JunctionId, std::uint32_t> on_curve = positions_on_curve(foam);
    const auto junction_key = [&](JunctionId junction) { return on_curve[junction]; };
    const auto film_key = [&](FilmId film) { return on_curve[network.tail(forward_side(film))]; };
    const auto bubble_key = [&](BubbleId bubble) {
        return on_curve[network.tail(network.first(bubble))];
    };
    Network::OldIds order = network.live_ids();
    const auto without_ghost = std::span(order.bubbles).first(network.bubble_count());
    std::ranges::stable_sort(order.junctions, {}, junction_key);
    std::ranges::stable_sort(order.films, {}, film_key);
    std::ranges::stable_sort(without_ghost, {}, bubble_key);
    renumber(foam, order);
}

void sort_if_large(Foam& foam) {
    if (foam.network.bubble_count() >= kMinSortedBubbles) {
        sort_along_curve(foam);
    }
}

}  // namespace foam
