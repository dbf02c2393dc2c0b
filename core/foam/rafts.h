// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"

namespace foam {

/// Returns true if the film separates the two bubbles of a raft of two bubbles.
bool is_inside_double_bubble(const Network& network, FilmId film);

/// Tears a film with the ghost at both ends (core/network/split.h) and records a T1. On each side
/// of the torn film, two outer films become one arc. One half angle keeps the old tangent at the
/// tail of the arc; usually, a different half angle keeps the old tangent at its head. The arc gets
/// the mean of the two half angles. A bubble that no longer touches another bubble becomes a lone
/// bubble. Its circle is tangent to the old outer film of this bubble at one end of the torn film.
/// Precondition: can_split.
void tear_film(Foam& foam, FilmId film);

/// Returns true if the outer film is at a hole of at most three films, all with chords shorter than
/// `length`. Precondition: the film is an outer film.
bool is_small_hole(const Foam& foam, FilmId film, double length);

/// Returns true if the outer film is at a hole in which bubbles overlap. The boundary of such a
/// hole encloses a negative area. Precondition: the film is an outer film.
bool is_overlapping_hole(const Foam& foam, FilmId film);

/// Closes the hole at an outer film. A hole of three films becomes a junction at the mean of its
/// three junctions. A hole of two films vanishes, and the two other films at its junctions become
/// one film. Records a T1 and returns true. If the hole has more than three films, or if the
/// network would not be valid afterwards (can_close_hole), changes nothing and returns false.
/// Precondition: the film is at a hole.
bool close_hole(Foam& foam, FilmId film);

}  // namespace foam
