#pragma once

#include "core/network/network.h"

namespace foam {

/// Puts a three-sided bubble in the place of a junction: the inverse of its T2 (E8). The junction
/// stays as one of the three; each bubble around it gains a side. New junctions and films lie in
/// the junction's lattice cell and have the last ids, and the new bubble's first half-edge leaves
/// the old junction, so that `vanish` and `compact` give the same network back.
BubbleId insert_triangle(Network& network, JunctionId junction);

/// Puts a two-sided bubble on a film: the inverse of its T2. The half-edge now starts at the lens
/// and ends where it did; a new film leads from its old tail to the lens. Each bubble beside the
/// film gains two sides. New junctions lie in the lattice cell of the old tail, the last ids are
/// new, and the new bubble's first half-edge leaves the tail of h, for the same reason as above.
BubbleId insert_lens(Network& network, HalfEdgeId h);

}  // namespace foam
