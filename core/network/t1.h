// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/network/network.h"

namespace foam {

/// The neighborhood of a film that is to swap neighbors. The half-edge `film` runs from v to w,
/// with bubble A on its left, B on its right, C beyond v and D beyond w.
struct T1Site {
    HalfEdgeId film;
    HalfEdgeId before_left;   // arrives at v along A
    HalfEdgeId after_left;    // leaves w along A
    HalfEdgeId before_right;  // arrives at w along B
    HalfEdgeId after_right;   // leaves v along B
    BubbleId end_tail;        // C
    BubbleId end_head;        // D
};

/// Returns the neighborhood of the film.
T1Site t1_site(const Network& network, FilmId film);

/// Returns true if the flip leaves a valid foam (E7): the bubbles beside the film keep at least two
/// sides, the film is not a loop, and the bubbles at its ends are not the same copy of one bubble.
/// Such a bubble would touch itself across the flipped film. If the ghost is beside the film, its
/// boundary along the film must keep at least two films. A film with the ghost at both ends cannot
/// flip (split.h).
bool can_flip(const Network& network, FilmId film);

/// Swaps neighbors at the film (E7; paper Figure 1). Afterwards both neighboring films along A end
/// at v, both neighboring films along B end at w, and the film separates C from D. The forward side
/// of the film runs from A to B, with D on its left. The lattice offset of the film is unchanged.
/// Precondition: can_flip.
void flip(Network& network, FilmId film);

}  // namespace foam
