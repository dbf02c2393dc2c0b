// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/network/network.h"

#include <vector>

namespace foam {

/// Returns true if the film is an inner film with the ghost at both ends. Such a film cannot flip,
/// because the flipped film would have the ghost on both sides. It may tear instead.
bool can_split(const Network& network, FilmId film);

/// The result of a split.
struct Split {
    std::vector<FilmId> joined;   // outer films, at most two, each the union of two films
    std::vector<BubbleId> loose;  // bubbles beside the film that have lost all their junctions
};

/// Removes the film and both its junctions. Each bubble beside the film has an outer film at either
/// end of the film; these two outer films become one film. If a bubble beside the film has only one
/// other film, that film and the bubble are also removed from the network. If both ends of the film
/// were on the same boundary of the ghost, the two bubbles beside the film belong to different
/// rafts afterwards. Otherwise, the boundaries at the two ends have become one; for example, a hole
/// is now open to the outside. Precondition: can_split.
Split split(Network& network, FilmId film);

/// Sets the first half-edge of the ghost to one of its live half-edges, after a change that may
/// have removed the old one. Does nothing if the ghost has no half-edge left.
void renew_first_of_ghost(Network& network);

}  // namespace foam
