#pragma once

#include "core/foam/foam.h"

namespace foam {

/// Whether the film parts the two bubbles of a raft of two.
bool is_inside_double_bubble(const Network& network, FilmId film);

/// Tears a film with the ghost at both ends (split.h): the two outer films on each side become one,
/// which keeps their directions at its ends as far as one arc can. A bubble that touches nothing
/// any more becomes a lone bubble where its outer film was. Precondition: can_split.
void tear_film(Foam& foam, FilmId film);

/// Whether an outer film goes around a hole of at most three films whose chords are all below a
/// length.
bool is_small_hole(const Foam& foam, FilmId film, double length);

/// Whether an outer film goes around a hole that has no area left: the bubbles around it overlap.
bool is_overlapping_hole(const Foam& foam, FilmId film);

/// Closes the hole at an outer film: three films become a junction at their mean, of two only the
/// films beside them are left, as one. False, with nothing changed, where it has more films, or
/// where that leaves no foam. Precondition: the film goes around a hole.
bool close_hole(Foam& foam, FilmId film);

}  // namespace foam
