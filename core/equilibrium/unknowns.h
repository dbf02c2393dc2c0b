#pragma once

#include "core/foam/foam.h"

#include <vector>

namespace foam {

/// The order in which a solver counts the unknowns of a foam: x and y of each live junction, then
/// the pressure of each live bubble, both by increasing id.
struct Unknowns {
    std::vector<JunctionId> junctions;
    std::vector<BubbleId> bubbles;
    std::vector<FilmId> films;               // by increasing id
    Indexed<JunctionId, int> junction_rank;  // place in `junctions`
    Indexed<BubbleId, int> bubble_rank;      // place in `bubbles`

    int size() const { return static_cast<int>(2 * junctions.size() + bubbles.size()); }
    int pressure_row(BubbleId bubble) const {
        return static_cast<int>(2 * junctions.size()) + bubble_rank[bubble];
    }
    /// Row of the x coordinate; y follows it.
    int position_row(JunctionId junction) const { return 2 * junction_rank[junction]; }
};

Unknowns all_unknowns(const Network& network);

}  // namespace foam
