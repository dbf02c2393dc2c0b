// SPDX-License-Identifier: Apache-2.0

#include "core/network/split.h"

#include "core/network/t1.h"

#include <array>
#include <cassert>

namespace foam {

namespace {

// One side of the torn film. The bubble on this side has two outer films that meet the torn film,
// one at each of its ends. If the bubble has only two sides, both are the same film.
struct TornSide {
    HalfEdgeId before;          // arrives at the torn film, with the bubble on its left
    HalfEdgeId after;           // leaves the torn film, with the bubble on its left
    HalfEdgeId ghost_previous;  // predecessor of twin(after) in the boundary of the ghost
};

TornSide torn_side(const Network& network, HalfEdgeId before, HalfEdgeId after) {
    return {before, after, network.previous(twin(after))};
}

void drop_sides(Network& network, BubbleId bubble, int sides) {
    network.set_sides(bubble, network.sides(bubble) - sides);
}

// Joins the two outer films: the film of `before` is extended to the end of the film of `after`.
// Returns the extended film. The caller must remove the film of `after`.
FilmId join(Network& network, const TornSide& side) {
    const HalfEdgeId kept = side.before;
    const BubbleId bubble = network.left(kept);
    network.set_next(kept, network.next(side.after));
    network.set_next(side.ghost_previous, twin(kept));
    network.set_tail(twin(kept), network.head(side.after));
    network.set_first(bubble, kept);
    network.set_first(network.ghost(), twin(kept));
    drop_sides(network, bubble, 2);
    return film_of(kept);
}

}  // namespace

void renew_first_of_ghost(Network& network) {
    for (const FilmId film : network.films()) {
        if (network.is_outer(film)) {
            const HalfEdgeId h = forward_side(film);
            network.set_first(network.ghost(), network.left(h) == network.ghost() ? h : twin(h));
            return;
        }
    }
}

bool can_split(const Network& network, FilmId film) {
    if (network.ghost() == kNone<BubbleId> || network.is_outer(film)) {
        return false;
    }
    const T1Site site = t1_site(network, film);
    return site.end_tail == network.ghost() && site.end_head == network.ghost();
}

Split split(Network& network, FilmId film) {
    assert(can_split(network, film));
    const T1Site site = t1_site(network, film);
    const std::array<TornSide, 2> sides{torn_side(network, site.before_left, site.after_left),
                                        torn_side(network, site.before_right, site.after_right)};
    const std::array<JunctionId, 2> removed_junctions{network.tail(site.film),
                                                      network.head(site.film)};
    Split result;
    for (const TornSide& side : sides) {
        const BubbleId bubble = network.left(side.before);
        if (side.before == side.after) {
            result.loose.push_back(bubble);
            network.remove(bubble);
        } else {
            result.joined.push_back(join(network, side));
        }
        network.remove(film_of(side.after));
        drop_sides(network, network.ghost(), 1);
    }
    network.remove(film);
    network.remove(removed_junctions[0]);
    network.remove(removed_junctions[1]);
    if (!result.loose.empty()) {
        renew_first_of_ghost(network);
    }
    return result;
}

}  // namespace foam
