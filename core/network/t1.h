// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/network/network.h"

namespace foam {

/// The neighborhood of a film that may be flipped. The half-edge `film` runs from junction v to
/// junction w, with bubble A on its left, B on its right, C beyond v and D beyond w. A half-edge
/// "along A" has A on its left.
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

/// Returns true if the network stays valid when the film is flipped. The bubbles beside the film
/// must keep at least two sides, and the film must not end at the junction at which it begins. The
/// bubbles at the two ends of the film must not be the same copy of one bubble, because this bubble
/// would touch itself across the flipped film. Two different periodic copies of one bubble of a
/// torus are allowed. If the ghost is beside the film, the boundary of the ghost that contains the
/// film must keep at least two films. A film with the ghost at both ends cannot flip, but may tear
/// (split.h).
bool can_flip(const Network& network, FilmId film);

/// Flips the film, which is a T1: the four bubbles around the film swap neighbors (E7; paper Figure
/// 1). Afterwards, in the notation of T1Site:
/// - the films of before_left and after_left both meet the film at v;
/// - the films of before_right and after_right both meet the film at w;
/// - the film separates C from D;
/// - the forward side of the film still runs from v to w, now from A to B, with D on its left.
///
/// The lattice offset of the film is unchanged. Precondition: can_flip.
void flip(Network& network, FilmId film);

}  // namespace foam
