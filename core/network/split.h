// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/network/network.h"

#include <vector>

namespace foam {

/// Returns true if the film is between two bubbles and has the ghost at both ends. If such a film
/// flipped, it would have the ghost on both sides; it tears instead.
bool can_split(const Network& network, FilmId film);

/// The result of a split.
struct Split {
    std::vector<FilmId> joined;   // outer films, at most two, each the union of two
    std::vector<BubbleId> loose;  // bubbles beside the film that lost their last junction
};

/// Removes the film and both its junctions. On each side, the two outer films that it separated
/// become one. A bubble that has no other film is removed from the network. The two bubbles then
/// belong to different rafts, or a hole at one end of the film has opened. Precondition: can_split.
Split split(Network& network, FilmId film);

/// Sets the first half-edge of the ghost to one of its live half-edges, after a change that may
/// have removed the old one. Does nothing if the ghost has no half-edge left.
void renew_first_of_ghost(Network& network);

}  // namespace foam
