// SPDX-License-Identifier: Apache-2.0

#include "core/equilibrium/unknowns.h"

#include <algorithm>

namespace foam {

namespace {

// Sorts the ids and removes duplicates.
template <class Id>
void sort_unique(std::vector<Id>& ids) {
    std::sort(ids.begin(), ids.end());
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
}

void find_outer_films(const Network& network, Unknowns& unknowns) {
    if (network.ghost() == kNone<BubbleId>) {
        return;
    }
    for (const FilmId film : unknowns.films) {
        if (network.is_outer(film)) {
            unknowns.outer_films.push_back(film);
        }
    }
    unknowns.outer_rank = {unknowns.outer_films, network.film_slots()};
}

void rank_all(const Network& network, Unknowns& unknowns) {
    find_outer_films(network, unknowns);
    unknowns.junction_rank = {unknowns.junctions, network.junction_slots()};
    unknowns.bubble_rank = {unknowns.bubbles, network.bubble_slots()};
}

}  // namespace

Unknowns all_unknowns(const Network& network) {
    Unknowns unknowns;
    unknowns.junctions = network.junctions().ids(network.junction_count());
    unknowns.bubbles = network.bubbles().ids(network.bubble_count());
    unknowns.films = network.films().ids(network.film_count());
    rank_all(network, unknowns);
    return unknowns;
}

Unknowns unknowns_around(const Network& network, std::span<const BubbleId> bubbles) {
    Unknowns unknowns;
    unknowns.bubbles.assign(bubbles.begin(), bubbles.end());
    for (const BubbleId bubble : bubbles) {
        for (const HalfEdgeId h : network.around(bubble)) {
            unknowns.junctions.push_back(network.tail(h));
        }
    }
    sort_unique(unknowns.junctions);
    for (const JunctionId junction : unknowns.junctions) {
        for (const HalfEdgeId h : network.leaving(junction)) {
            unknowns.films.push_back(film_of(h));
        }
    }
    sort_unique(unknowns.films);
    rank_all(network, unknowns);
    return unknowns;
}

}  // namespace foam
