// SPDX-License-Identifier: Apache-2.0

#include "core/foam/spatial_order.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

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

// The smallest square around all junctions.
struct Square {
    Vec2 low;
    double side;
};

Square square_around(const Foam& foam) {
    Vec2 low = foam.positions[*foam.network.junctions().begin()];
    Vec2 high = low;
    for (const JunctionId junction : foam.network.junctions()) {
        low = low.cwiseMin(foam.positions[junction]);
        high = high.cwiseMax(foam.positions[junction]);
    }
    return {low, (high - low).maxCoeff()};
}

// Sorts ids by the position along the curve of a junction of the element. Ids at the same position
// keep their order.
template <class Id, class JunctionOf>
void sort_ids(std::vector<Id>& ids,
              const Indexed<JunctionId, std::uint32_t>& positions,
              const JunctionOf& junction_of) {
    std::stable_sort(ids.begin(), ids.end(), [&](Id a, Id b) {
        return positions[junction_of(a)] < positions[junction_of(b)];
    });
}

}  // namespace

void sort_along_curve(Foam& foam) {
    const Network& network = foam.network;
    if (network.junction_count() == 0) {
        return;
    }
    const Square square = square_around(foam);
    const double scale = square.side > 0.0 ? ((1U << kLevels) - 1U) / square.side : 0.0;
    Indexed<JunctionId, std::uint32_t> positions(network.junction_slots(), 0);
    for (const JunctionId junction : network.junctions()) {
        const Vec2 at = scale * (foam.positions[junction] - square.low);
        positions[junction] = position_on_curve(static_cast<std::uint32_t>(at.x()),
                                                static_cast<std::uint32_t>(at.y()));
    }
    Network::OldIds order = network.live_ids();
    sort_ids(order.junctions, positions, [](JunctionId junction) { return junction; });
    sort_ids(order.films, positions, [&](FilmId film) { return network.tail(forward_side(film)); });
    sort_ids(order.bubbles, positions, [&](BubbleId bubble) {
        return network.tail(network.first(bubble));
    });
    renumber(foam, order);
}

void sort_if_large(Foam& foam) {
    if (foam.network.bubble_count() >= kMinSortedBubbles) {
        sort_along_curve(foam);
    }
}

}  // namespace foam
