// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/network/network.h"

#include <vector>

namespace foam {

/// Returns true if the bubble has two or three sides and each bubble around it would keep at least
/// two sides if it vanished.
bool can_vanish(const Network& network, BubbleId bubble);

/// The elements that replace a vanished bubble.
struct Vanished {
    // The junction where the films at the three corners of a three-sided bubble now meet.
    JunctionId junction = kNone<JunctionId>;
    // The union of the films at the two corners of a two-sided bubble.
    FilmId film = kNone<FilmId>;
    std::vector<BubbleId> neighbors;  // one entry per side, counter-clockwise
};

/// Removes a bubble by the T2 process (E8; paper Figure 2). Of the three junctions of a three-sided
/// bubble, the tail of `first(bubble)` remains, in its own lattice cell. The films at all three
/// corners then meet there. Precondition: can_vanish.
Vanished vanish(Network& network, BubbleId bubble);

/// Returns true if a hole can close. The conditions are those of can_vanish. `boundary` is the
/// boundary of the ghost in the hole: its half-edges, in order.
bool can_close(const Network& network, const std::vector<HalfEdgeId>& boundary);
/// Removes a hole as `vanish` removes a bubble. Precondition: can_close.
Vanished close(Network& network, const std::vector<HalfEdgeId>& boundary);

}  // namespace foam
