// SPDX-License-Identifier: Apache-2.0

#include "core/equilibrium/flip_short_films.h"

#include "core/foam/t1_rule.h"
#include "core/network/t1.h"

#include <vector>

namespace foam {

namespace {

FourBubbles bubbles_around(const Network& network, FilmId film) {
    const T1Site site = t1_site(network, film);
    return {network.left(site.film), network.right(site.film), site.end_tail, site.end_head};
}

bool is_within(const Foam& foam, const Unknowns& part, FilmId film) {
    const HalfEdgeId h = forward_side(film);
    return part.junction_rank[foam.network.tail(h)] >= 0 &&
           part.junction_rank[foam.network.head(h)] >= 0;
}

// Erases from `part` the ids of elements that are no longer in the network. If a film tears or a
// hole closes, junctions and films are removed from the network. The T1 rule removes no bubble; ids
// of bubbles are erased only as a precaution.
void remove_dead(const Network& network, Unknowns& part) {
    const auto is_dead = [&](auto id) { return !network.is_live(id); };
    std::erase_if(part.junctions, is_dead);
    std::erase_if(part.films, is_dead);
    std::erase_if(part.bubbles, is_dead);
}

}  // namespace

int flip_short_films(Foam& foam,
                     Unknowns& part,
                     const TopologyThresholds& thresholds,
                     const OnT1Rule& on_t1_rule) {
    int changes = 0;
    for (const FilmId film : part.films) {
        if (!foam.network.is_live(film) || !is_within(foam, part, film)) {
            continue;
        }
        if (chord(foam, forward_side(film)).norm() < thresholds.t1_distance) {
            const FourBubbles around = bubbles_around(foam.network, film);
            const bool changed = apply_t1_rule(foam, film, thresholds);
            on_t1_rule(film, around, changed);
            changes += changed ? 1 : 0;
        }
    }
    if (changes > 0) {
        remove_dead(foam.network, part);
    }
    return changes;
}

}  // namespace foam
