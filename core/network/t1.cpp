// SPDX-License-Identifier: Apache-2.0

#include "core/network/t1.h"

#include <cassert>

// The notation is that of T1Site. A film leads from the junction v to the junction w. C is the
// bubble at v that is not beside the film, and D is the bubble at w that is not beside it. The flip
// keeps the film and both junctions; afterwards, the film is between C and D. The flip moves the
// tail of the half-edge `after_left` from w to v, and the tail of `after_right` from v to w. The
// lattice offsets of the films of these two half-edges change by the offset of the flipped film.

namespace foam {

namespace {

// Returns true if the corner of C at v and the corner of D at w belong to the same copy of the same
// bubble. The ghost counts as one copy, however many boundaries it has.
bool ends_meet(const Network& network, const T1Site& site) {
    if (site.end_tail != site.end_head || site.end_tail == network.ghost()) {
        return site.end_tail == site.end_head;
    }
    const HalfEdgeId start = twin(site.before_left);    // leaves v along C
    const HalfEdgeId target = twin(site.before_right);  // leaves w along D
    const LatticeOffset film_offset = network.offset(site.film);
    LatticeOffset offset_from_start;
    HalfEdgeId h = start;
    do {
        if (h == target && offset_from_start == film_offset) {
            return true;
        }
        offset_from_start = offset_from_start + network.offset(h);
        h = network.next(h);
    } while (h != start);
    return false;
}

// Returns true if the bubble on the left of h keeps at least two sides after the loss of `lost`
// sides. If that bubble is the ghost, returns true if the boundary that contains h has more than
// two half-edges.
bool keeps_two_sides(const Network& network, HalfEdgeId h, int lost) {
    const BubbleId bubble = network.left(h);
    return bubble == network.ghost() ? network.next(network.next(h)) != h
                                     : network.sides(bubble) - lost >= 2;
}

void move_neighboring_films(Network& network, const T1Site& site) {
    const JunctionId v = network.tail(site.film);
    const JunctionId w = network.head(site.film);
    const LatticeOffset film_offset = network.offset(site.film);
    network.set_offset(site.after_left, film_offset + network.offset(site.after_left));
    network.set_offset(site.after_right, network.offset(site.after_right) - film_offset);
    network.set_tail(site.after_left, v);
    network.set_tail(site.after_right, w);
    network.set_tail(site.film, v);
    network.set_tail(twin(site.film), w);
}

}  // namespace

T1Site t1_site(const Network& network, FilmId film) {
    const HalfEdgeId h = forward_side(film);
    const HalfEdgeId t = twin(h);
    T1Site site{h,
                network.previous(h),
                network.next(h),
                network.previous(t),
                network.next(t),
                kNone<BubbleId>,
                kNone<BubbleId>};
    site.end_tail = network.left(twin(site.before_left));
    site.end_head = network.left(twin(site.before_right));
    return site;
}

bool can_flip(const Network& network, FilmId film) {
    const T1Site site = t1_site(network, film);
    const BubbleId a = network.left(site.film);
    const BubbleId b = network.right(site.film);
    const int lost_sides = a == b ? 2 : 1;
    return network.tail(site.film) != network.head(site.film) &&
           keeps_two_sides(network, site.film, lost_sides) &&
           keeps_two_sides(network, twin(site.film), lost_sides) && !ends_meet(network, site);
}

void flip(Network& network, FilmId film) {
    assert(can_flip(network, film));
    const T1Site site = t1_site(network, film);
    const HalfEdgeId h = site.film;
    const HalfEdgeId t = twin(h);
    const BubbleId a = network.left(h);
    const BubbleId b = network.left(t);

    move_neighboring_films(network, site);
    network.set_next(site.before_left, site.after_left);
    network.set_next(site.before_right, site.after_right);
    network.set_next(twin(site.after_left), h);
    network.set_next(h, twin(site.before_right));
    network.set_next(twin(site.after_right), t);
    network.set_next(t, twin(site.before_left));
    network.set_left(h, site.end_head);
    network.set_left(t, site.end_tail);
    network.set_first(a, site.after_left);
    network.set_first(b, site.after_right);
    network.set_sides(a, network.sides(a) - 1);
    network.set_sides(b, network.sides(b) - 1);
    network.set_sides(site.end_tail, network.sides(site.end_tail) + 1);
    network.set_sides(site.end_head, network.sides(site.end_head) + 1);
}

}  // namespace foam
