#include "core/equilibrium/unknowns.h"

namespace foam {

Unknowns all_unknowns(const Network& network) {
    Unknowns unknowns;
    unknowns.junction_rank.resize(network.junction_slots(), -1);
    unknowns.bubble_rank.resize(network.bubble_slots(), -1);
    for (const JunctionId junction : network.junctions()) {
        unknowns.junction_rank[junction] = static_cast<int>(unknowns.junctions.size());
        unknowns.junctions.push_back(junction);
    }
    for (const BubbleId bubble : network.bubbles()) {
        unknowns.bubble_rank[bubble] = static_cast<int>(unknowns.bubbles.size());
        unknowns.bubbles.push_back(bubble);
    }
    for (const FilmId film : network.films()) {
        unknowns.films.push_back(film);
    }
    return unknowns;
}

}  // namespace foam
