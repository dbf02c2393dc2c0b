#pragma once

#include "core/foam/foam.h"

#include <span>
#include <vector>

namespace foam {

/// The unknowns that a solver works on, and the order in which it counts them: x and y of each free
/// junction, then the pressure of each free bubble, both by increasing id. All others are held.
struct Unknowns {
    std::vector<JunctionId> junctions;
    std::vector<BubbleId> bubbles;
    std::vector<FilmId> films;               // of the free junctions and bubbles, by increasing id
    Indexed<JunctionId, int> junction_rank;  // place in `junctions`, negative for one that is held
    Indexed<BubbleId, int> bubble_rank;      // place in `bubbles`, likewise

    int size() const { return static_cast<int>(2 * junctions.size() + bubbles.size()); }
    /// Negative for a bubble that is held.
    int pressure_row(BubbleId bubble) const {
        const int rank = bubble_rank[bubble];
        return rank < 0 ? -1 : static_cast<int>(2 * junctions.size()) + rank;
    }
    /// Row of the x coordinate; y follows it. Negative for a junction that is held.
    int position_row(JunctionId junction) const { return 2 * junction_rank[junction]; }
};

/// Everything in the foam that is alive.
Unknowns all_unknowns(const Network& network);

/// The given bubbles, in increasing order and each once, with all their junctions.
Unknowns unknowns_around(const Network& network, std::span<const BubbleId> bubbles);

}  // namespace foam
