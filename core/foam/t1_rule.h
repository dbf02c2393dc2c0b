// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"
#include "core/foam/topology_thresholds.h"

#include <span>
#include <vector>

namespace foam {

/// Applies the T1 rule (E7): decides whether a film flips, tears, closes a hole or is reopened, and
/// performs the change. The functions that change the network are in core/network (t1.h, split.h,
/// t2.h) and rafts.h.
///
/// The cases are tried in this order. A film with the ghost at both ends tears instead of flipping,
/// because the flipped film would have the ghost on both sides. An outer film at a small hole
/// closes the hole. An outer film at a hole in which bubbles overlap closes the hole or flips. A
/// collapsed film is reopened (reopen_film). Any other short film flips if its flipped state stays
/// open (flipped_pulls_apart).
///
/// Returns true if the network changed; the film may then have been removed.
bool apply_t1_rule(Foam& foam, FilmId film, const TopologyThresholds& thresholds);

/// Applies the T1 rule to the films in their order, except to films that an earlier change has
/// removed. Returns the number of changes of the network.
int apply_t1_rule(Foam& foam, std::span<const FilmId> films, const TopologyThresholds& thresholds);

/// Returns the films below their T1 distance that would stay open when flipped, or would tear, in
/// increasing order.
std::vector<FilmId> short_films(const Foam& foam, const TopologyThresholds& thresholds);

/// Returns the length below which the film may flip: the T1 distance, times the square root of the
/// smallest target area of the four bubbles around the film if that is below 1. For a film that has
/// flipped and has not grown since (rearm_grown_films), it is a tenth of this length.
double t1_length(const Foam& foam, FilmId film, const TopologyThresholds& thresholds);

/// Returns the length below which the film counts as collapsed to a point where four films meet.
double collapsed_length(const Foam& foam, FilmId film, const TopologyThresholds& thresholds);

/// Returns true if the flipped film would stay open: if the mean pull of the four films at its
/// ends, along the flipped film, exceeds its own tension. If the film would tear instead of flip,
/// the threshold is 0, because no film then pulls the two sides together.
bool flipped_pulls_apart(const Foam& foam, FilmId film);

/// Flips the film (t1.h) and disarms it. The chord of the flipped film is the old chord, rotated by
/// 90 degrees around its midpoint (paper section 3). Precondition: can_flip.
void flip_film(Foam& foam, FilmId film);

/// Opens a film that has collapsed to a point where four films meet. Flips the film if it can flip
/// and these films would pull the flipped film harder than the present one. Gives the film the
/// direction of the pull and the given length, and keeps its midpoint. A flip is recorded as a T1
/// and disarms the film, as in flip_film. Returns true if the film was flipped.
bool reopen_film(Foam& foam, FilmId film, double length);

/// Returns true if the film has the ghost at both ends (split.h) and both bubbles beside it have
/// more than two sides. A bubble of two sides is stable at any size, so its film does not tear.
bool can_tear(const Network& network, FilmId film);

/// Returns true if the film can flip or tear.
bool can_change(const Network& network, FilmId film);

/// Arms those of the given films that have grown to twice their T1 distance.
void rearm_grown_films(Foam& foam,
                       std::span<const FilmId> films,
                       const TopologyThresholds& thresholds);
/// Arms the films of the foam that have grown to twice their T1 distance.
void rearm_grown_films(Foam& foam, const TopologyThresholds& thresholds);

}  // namespace foam
