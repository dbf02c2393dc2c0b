// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/network/network.h"

namespace foam {

/// Replaces a junction by a three-sided bubble and returns the bubble. This is the inverse of the
/// T2 of that bubble (E8, E10). The junction becomes one of the three corners of the new bubble.
/// Each bubble around the junction gains a side.
///
/// If the network was compact (Network::is_compact), two calls restore it: `vanish` (t2.h) removes
/// the new bubble, and renumber(live_ids()) removes the dead slots. There is one exception:
/// outgoing() of a junction and first() of a bubble may be other half-edges than before the
/// insertion. Three properties of the insertion make the restoration possible:
/// - the new films have a lattice offset of zero;
/// - the new elements have the highest ids of their kinds;
/// - the first half-edge of the new bubble leaves the old junction.
BubbleId insert_triangle(Network& network, JunctionId junction);

/// Inserts a two-sided bubble, a lens, into the film of h and returns the bubble. This is the
/// inverse of the T2 of that bubble (E10). Afterwards h starts at the lens and has the same head as
/// before. A new film leads from the old tail of h to the lens. Each bubble beside the film gains
/// two sides. `vanish` and `renumber` restore a compact network as described for insert_triangle.
/// The first half-edge of the new bubble leaves the new tail of h.
BubbleId insert_lens(Network& network, HalfEdgeId h);

}  // namespace foam
