// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/network/network.h"

#include <vector>

namespace foam {

/// Returns true if the bubble can vanish by a T2. It must have two or three sides and must not be
/// its own neighbor, and each bubble around it must keep at least two sides. At each corner of the
/// bubble, one film ends that is not a side of the bubble: the film at the corner. The films at the
/// two corners of a two-sided bubble must be different films.
bool can_vanish(const Network& network, BubbleId bubble);

/// The result of a T2: the junction or film that replaces the bubble, and the former neighbors of
/// the bubble.
struct Vanished {
    // The junction where the films at the three corners of a three-sided bubble now meet; kNone if
    // the bubble had two sides.
    JunctionId junction = kNone<JunctionId>;
    // The union of the films at the two corners of a two-sided bubble; kNone if the bubble had
    // three sides.
    FilmId film = kNone<FilmId>;
    std::vector<BubbleId> neighbors;  // the bubble across each side, counter-clockwise
};

/// Removes a bubble by the T2 process (E8; paper Figure 2). A three-sided bubble is replaced by one
/// of its junctions, the tail of `first(bubble)`: the films at its three corners then meet there.
/// The lattice offsets of these films are relative to the present position of this junction; a
/// caller that moves the junction by whole periods must call Network::rebase. A two-sided bubble is
/// removed with both its junctions, and the films at its two corners become one film. Precondition:
/// can_vanish.
Vanished vanish(Network& network, BubbleId bubble);

/// Returns true if a hole can close. The conditions are those of can_vanish for a bubble in place
/// of the hole. `boundary` contains the half-edges of the ghost around the hole, in order.
bool can_close_hole(const Network& network, const std::vector<HalfEdgeId>& boundary);
/// Removes a hole as `vanish` removes a bubble; boundary.front() takes the role of first(bubble).
/// Precondition: can_close_hole.
Vanished close_hole(Network& network, const std::vector<HalfEdgeId>& boundary);

}  // namespace foam
