#pragma once

#include "core/network/network.h"

#include <vector>

namespace foam {

/// Whether both ends of a film between two bubbles touch the ghost: flipped, it would have the
/// ghost on both sides. Instead, it tears.
bool can_split(const Network& network, FilmId film);

/// What is left where a film has torn.
struct Split {
    std::vector<FilmId> joined;   // outer films that were two and are one; at most two
    std::vector<BubbleId> loose;  // of those beside the film, any that lost its last junction
};

/// Removes the film and both its junctions: on each side, the two outer films that it kept apart
/// become one. A bubble that has no other film leaves the network. The two bubbles are then parts
/// of different rafts, or the hole at one end has opened. Precondition: can_split.
Split split(Network& network, FilmId film);

/// After a change that may have taken it away: any half-edge of the ghost that is left, as its
/// first.
void renew_first_of_ghost(Network& network);

}  // namespace foam
