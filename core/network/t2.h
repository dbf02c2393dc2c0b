#pragma once

#include "core/network/network.h"

#include <vector>

namespace foam {

/// Whether a bubble of two or three sides can vanish: each bubble around it keeps two sides.
bool can_vanish(const Network& network, BubbleId bubble);

/// What is left where a bubble has vanished.
struct Vanished {
    JunctionId junction =
        kNone<JunctionId>;             // of a three-sided bubble: where its three outer films meet
    FilmId film = kNone<FilmId>;       // of a two-sided bubble: its two outer films, now one
    std::vector<BubbleId> neighbours;  // one entry per side, counter-clockwise
};

/// The T2 process (E8; paper Figure 2). Of three junctions the tail of `first(bubble)` remains and
/// takes the three outer films, in its own lattice cell. Precondition: can_vanish.
Vanished vanish(Network& network, BubbleId bubble);

/// The same for a hole: a boundary of the ghost, all its half-edges given in their order.
bool can_close(const Network& network, const std::vector<HalfEdgeId>& boundary);
Vanished close(Network& network, const std::vector<HalfEdgeId>& boundary);

}  // namespace foam
