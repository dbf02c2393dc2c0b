// SPDX-License-Identifier: Apache-2.0

#include "core/network/t2.h"

#include "core/network/split.h"

#include <algorithm>
#include <array>
#include <cassert>

// A three-sided bubble is replaced by one of its junctions. The films at its three corners then all
// end at this junction, so the lattice offsets of these films change by the offsets along the
// bubble's sides. A two-sided bubble is removed with both its junctions, and the films at its two
// corners become one film. A hole of two or three films closes in the same way.
//
// In this file, a loop is the list of the half-edges around the bubble that vanishes, with this
// bubble on their left. The loop around a hole consists of half-edges of the ghost.

namespace foam {

namespace {

// Returns the half-edge that leaves the tail of h away from the bubble on the left of h.
HalfEdgeId outward_half_edge(const Network& network, HalfEdgeId h) {
    return network.next(twin(h));
}

std::vector<BubbleId> neighbors_of(const Network& network, const std::vector<HalfEdgeId>& loop) {
    std::vector<BubbleId> neighbors;
    neighbors.reserve(loop.size());
    for (const HalfEdgeId h : loop) {
        neighbors.push_back(network.right(h));
    }
    return neighbors;
}

void subtract_sides(Network& network, BubbleId bubble, int count) {
    network.set_sides(bubble, network.sides(bubble) - count);
}

// Removes the bubble inside the loop. If this bubble is the ghost, only subtracts the sides of the
// hole from the sides of the ghost.
void remove_inside(Network& network, BubbleId inside, int sides) {
    if (inside == network.ghost()) {
        subtract_sides(network, inside, sides);
    } else {
        network.remove(inside);
    }
}

Vanished vanish_three_sided(Network& network, const std::vector<HalfEdgeId>& loop) {
    const BubbleId inside = network.left(loop[0]);
    Vanished vanished{network.tail(loop[0]), kNone<FilmId>, neighbors_of(network, loop)};
    const std::array<HalfEdgeId, 3> outward{outward_half_edge(network, loop[0]),
                                            outward_half_edge(network, loop[1]),
                                            outward_half_edge(network, loop[2])};
    const std::array<JunctionId, 2> removed_junctions{network.tail(loop[1]), network.tail(loop[2])};
    LatticeOffset offset_from_first;  // from the tail of loop[0] to the tail of loop[i]
    for (std::size_t i = 0; i < 3; ++i) {
        network.set_offset(outward[i], offset_from_first + network.offset(outward[i]));
        offset_from_first = offset_from_first + network.offset(loop[i]);
    }
    for (std::size_t i = 0; i < 3; ++i) {
        const BubbleId neighbor = vanished.neighbors[i];
        network.set_next(twin(outward[(i + 1) % 3]), outward[i]);
        network.set_tail(outward[i], vanished.junction);
        network.set_first(neighbor, outward[i]);
        subtract_sides(network, neighbor, 1);
    }
    for (const HalfEdgeId h : loop) {
        network.remove(film_of(h));
    }
    for (const JunctionId junction : removed_junctions) {
        network.remove(junction);
    }
    remove_inside(network, inside, 3);
    return vanished;
}

Vanished vanish_two_sided(Network& network, const std::vector<HalfEdgeId>& loop) {
    const BubbleId inside = network.left(loop[0]);
    const HalfEdgeId kept = outward_half_edge(network, loop[0]);
    const HalfEdgeId dropped = outward_half_edge(network, loop[1]);
    Vanished vanished{kNone<JunctionId>, film_of(kept), neighbors_of(network, loop)};
    const JunctionId removed_0 = network.tail(loop[0]);
    const JunctionId removed_1 = network.tail(loop[1]);

    network.set_offset(kept,
                       network.offset(kept) - network.offset(loop[0]) - network.offset(dropped));
    network.set_next(network.previous(twin(dropped)), kept);
    network.set_next(twin(kept), network.next(dropped));
    network.set_tail(kept, network.head(dropped));
    for (const HalfEdgeId side : {kept, twin(kept)}) {
        network.set_first(network.left(side), side);
        subtract_sides(network, network.left(side), 2);
    }
    for (const HalfEdgeId h : {loop[0], loop[1], dropped}) {
        network.remove(film_of(h));
    }
    network.remove(removed_0);
    network.remove(removed_1);
    remove_inside(network, inside, 2);
    return vanished;
}

bool can_vanish_along(const Network& network, const std::vector<HalfEdgeId>& loop) {
    const BubbleId inside = network.left(loop.front());
    const std::vector<BubbleId> neighbors = neighbors_of(network, loop);
    if (loop.size() == 2 && film_of(outward_half_edge(network, loop[0])) ==
                                film_of(outward_half_edge(network, loop[1]))) {
        return false;
    }
    const int lost_per_side = loop.size() == 2 ? 2 : 1;
    return std::all_of(neighbors.begin(), neighbors.end(), [&](BubbleId neighbor) {
        const auto shared = std::count(neighbors.begin(), neighbors.end(), neighbor);
        return neighbor != inside &&
               network.sides(neighbor) - lost_per_side * static_cast<int>(shared) >= 2;
    });
}

Vanished vanish_along(Network& network, const std::vector<HalfEdgeId>& loop) {
    return loop.size() == 3 ? vanish_three_sided(network, loop) : vanish_two_sided(network, loop);
}

}  // namespace

bool can_vanish(const Network& network, BubbleId bubble) {
    const int sides = network.sides(bubble);
    return (sides == 2 || sides == 3) && can_vanish_along(network, network.around(bubble));
}

Vanished vanish(Network& network, BubbleId bubble) {
    assert(can_vanish(network, bubble));
    return vanish_along(network, network.around(bubble));
}

bool can_close_hole(const Network& network, const std::vector<HalfEdgeId>& boundary) {
    return (boundary.size() == 2 || boundary.size() == 3) && can_vanish_along(network, boundary);
}

Vanished close_hole(Network& network, const std::vector<HalfEdgeId>& boundary) {
    assert(can_close_hole(network, boundary));
    Vanished vanished = vanish_along(network, boundary);
    renew_first_of_ghost(network);
    return vanished;
}

}  // namespace foam
