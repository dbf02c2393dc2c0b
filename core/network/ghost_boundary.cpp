// SPDX-License-Identifier: Apache-2.0

#include "core/network/ghost_boundary.h"

#include <vector>

namespace foam {

namespace {

// Returns, for each half-edge, its predecessor around the bubble on its left, or kNone if there is
// no bubble on its left.
std::vector<HalfEdgeId> predecessors(const Network& network) {
    std::vector<HalfEdgeId> predecessor(2 * network.film_slots(), kNone<HalfEdgeId>);
    for (const BubbleId bubble : network.bubbles()) {
        for (const HalfEdgeId h : network.around(bubble)) {
            predecessor[index_of(network.next(h))] = h;
        }
    }
    return predecessor;
}

// Makes the ghost the left bubble of every half-edge that has no bubble on its left, and sets the
// tail of the half-edge. Returns these half-edges.
std::vector<HalfEdgeId> take_outer_sides(Network& network, BubbleId ghost) {
    std::vector<HalfEdgeId> sides;
    for (const FilmId film : network.films()) {
        for (const HalfEdgeId h : {forward_side(film), twin(forward_side(film))}) {
            if (network.left(h) == kNone<BubbleId>) {
                network.set_tail(h, network.tail(network.next(twin(h))));
                network.set_left(h, ghost);
                sides.push_back(h);
            }
        }
    }
    return sides;
}

}  // namespace

// The successor of a half-edge of the ghost leaves the junction at the head of the half-edge. The
// successor is found by circulating around this junction, from bubble to bubble, until a half-edge
// of the ghost is reached.
void add_ghost_boundary(Network& network) {
    const std::vector<HalfEdgeId> predecessor = predecessors(network);
    const BubbleId ghost = network.add_ghost();
    const std::vector<HalfEdgeId> sides = take_outer_sides(network, ghost);
    for (const HalfEdgeId h : sides) {
        HalfEdgeId leaving = twin(h);
        while (network.left(leaving) != ghost) {
            leaving = twin(predecessor[index_of(leaving)]);
        }
        network.set_next(h, leaving);
    }
    network.set_sides(ghost, static_cast<int>(sides.size()));
    network.set_first(ghost, sides.empty() ? kNone<HalfEdgeId> : sides.front());
}

}  // namespace foam
