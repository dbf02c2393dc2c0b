// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"

namespace foam {

/// Returns true if the film is the one between the two bubbles of a raft of two.
bool is_inside_double_bubble(const Network& network, FilmId film);

/// Tears a film with the ghost at both ends (split.h): the two outer films on each side become one,
/// which keeps their directions at its ends as far as one arc can. A bubble that no longer touches
/// another becomes a lone bubble where its outer film was. Precondition: can_split.
void tear_film(Foam& foam, FilmId film);

/// Returns true if the outer film is at a hole of at most three films, all of them shorter than
/// `length`.
bool is_small_hole(const Foam& foam, FilmId film, double length);

/// Returns true if the outer film is at a hole without area: the bubbles around it overlap.
bool is_overlapping_hole(const Foam& foam, FilmId film);

/// Closes the hole at an outer film: three films become a junction at the mean of their junctions;
/// two films vanish, and the films beside them become one. Returns false, with nothing changed, if
/// the hole has more films, or if no valid network would remain. Precondition: the film is at a
/// hole.
bool close_hole(Foam& foam, FilmId film);

}  // namespace foam
