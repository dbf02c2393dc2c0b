// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"

namespace foam {

/// Returns true if the film separates the two bubbles of a raft of two.
bool is_inside_double_bubble(const Network& network, FilmId film);

/// Tears a film with the ghost at both ends (split.h): the two outer films on each side become one
/// arc, which fits their directions at its ends as closely as one arc can. A bubble that no longer
/// touches another bubble becomes a lone bubble at the position of its outer film. Precondition:
/// can_split.
void tear_film(Foam& foam, FilmId film);

/// Returns true if the outer film is at a hole of at most three films, all of them shorter than
/// `length`.
bool is_small_hole(const Foam& foam, FilmId film, double length);

/// Returns true if the outer film is at a hole of negative area, in which bubbles overlap.
bool is_overlapping_hole(const Foam& foam, FilmId film);

/// Closes the hole at an outer film. A hole of three films becomes a junction at the mean of their
/// junctions; a hole of two films vanishes, and the films beside it become one. Returns false and
/// changes nothing if the hole has more films, or if no valid network would remain. Precondition:
/// the film is at a hole.
bool close_hole(Foam& foam, FilmId film);

}  // namespace foam
