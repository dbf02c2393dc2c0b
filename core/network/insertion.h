// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/network/network.h"

namespace foam {

/// Replaces a junction by a three-sided bubble, and returns the bubble: the inverse of its T2 (E8,
/// E10). The junction remains as one of the three; each bubble around it gains a side. New
/// junctions are in the lattice cell of the junction, new ids are the last ones, and the first
/// half-edge of the new bubble leaves the old junction, so that `vanish` and `compact` restore the
/// same network.
BubbleId insert_triangle(Network& network, JunctionId junction);

/// Inserts a two-sided bubble, a lens, into a film, and returns the bubble: the inverse of its T2.
/// Afterwards h starts at the lens and ends where it did; a new film leads from the old tail of h
/// to the lens. Each bubble beside the film gains two sides. New junctions are in the lattice cell
/// of the old tail, new ids are the last ones, and the first half-edge of the new bubble leaves the
/// new tail of h, so that `vanish` and `compact` restore the same network.
BubbleId insert_lens(Network& network, HalfEdgeId h);

}  // namespace foam
