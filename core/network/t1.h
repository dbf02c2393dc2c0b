#pragma once

#include "core/network/network.h"

namespace foam {

/// The neighbourhood of a film that is to swap neighbours. In the sense of the half-edge `film`
/// from v to w: A on its left, B on its right, C beyond v, D beyond w.
struct T1Site {
    HalfEdgeId film;
    HalfEdgeId before_left;   // arrives at v along A
    HalfEdgeId after_left;    // leaves w along A
    HalfEdgeId before_right;  // arrives at w along B
    HalfEdgeId after_right;   // leaves v along B
    BubbleId end_tail;        // C
    BubbleId end_head;        // D
};

T1Site t1_site(const Network& network, FilmId film);

/// Whether the flip leaves a valid foam: the bubbles beside the film keep two sides, the ends are
/// not the same copy of one bubble (which would wrap around and touch itself), and the film is no
/// loop (E7). Each boundary of the ghost counts as a bubble here; a film with the ghost at both
/// ends does not flip (split.h).
bool can_flip(const Network& network, FilmId film);

/// The neighbour swap (E7; paper Figure 1): v takes the two outer films of A, w those of B, and the
/// film now parts C from D. Its forward side then runs from the side of A to the side of B, with D
/// on its left; its lattice offset stays. Precondition: can_flip.
void flip(Network& network, FilmId film);

}  // namespace foam
