// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"
#include "core/foam/topology_thresholds.h"

#include <span>
#include <vector>

namespace foam {

/// The T1 rule (E7): decides whether a film flips, tears, closes a hole or is opened anew, and does
/// it. The surgery itself is in core/network (t1.h, split.h, t2.h) and rafts.h.
///
/// In order: a film with the ghost at both ends tears where it would otherwise flip, since nothing
/// holds the flipped film together. An outer film around a small hole closes the hole; one around a
/// hole in which bubbles overlap closes it or flips. A collapsed film is opened anew (reopen_film).
/// Another short film flips if its flipped state stays open (flipped_pulls_apart).
///
/// Returns true if the network changed; the film may then be gone.
bool apply_t1_rule(Foam& foam, FilmId film, const TopologyThresholds& thresholds);

/// Applies the T1 rule to each of the films in their order, except to those that an earlier change
/// has removed. Returns the number of changes of the network.
int apply_t1_rule(Foam& foam, std::span<const FilmId> films, const TopologyThresholds& thresholds);

/// Returns the films below their T1 distance that would stay open when flipped, or would tear, in
/// increasing order.
std::vector<FilmId> short_films(const Foam& foam, const TopologyThresholds& thresholds);

/// Returns the length below which the film may flip: the T1 distance, times the square root of the
/// smallest target area of the four bubbles around the film if that is below 1. For a film that has
/// flipped and has not grown since (rearm_grown_films), it is a tenth of that.
double t1_length(const Foam& foam, FilmId film, const TopologyThresholds& thresholds);

/// Returns the length below which the film counts as collapsed to a point where four films meet.
double collapsed_length(const Foam& foam, FilmId film, const TopologyThresholds& thresholds);

/// Returns true if the four films at its ends would pull the flipped film apart: if their mean pull
/// along it exceeds its own tension. If the film would tear instead of flip, the threshold is 0,
/// because nothing then pulls the two sides together.
bool flipped_pulls_apart(const Foam& foam, FilmId film);

/// Flips the film (t1.h), sets its junctions perpendicular to the old film around its middle at the
/// same distance (paper 3), and disarms it. Precondition: can_flip.
void flip_film(Foam& foam, FilmId film);

/// Opens a film that has collapsed to a point of four films: places it, with the given length, in
/// the direction in which the films at its ends pull the hardest, flipped or not. Returns true if
/// it was flipped.
bool reopen_film(Foam& foam, FilmId film, double length);

/// Returns true if the film has the ghost at both ends (split.h) and both its bubbles have more
/// than two sides. A bubble of two sides is stable at any size, so its film does not tear.
bool can_tear(const Network& network, FilmId film);

/// Returns true if the film can flip or tear.
bool can_change(const Network& network, FilmId film);

/// Arms each of the films that has grown to twice the T1 distance at it.
void rearm_grown_films(Foam& foam,
                       std::span<const FilmId> films,
                       const TopologyThresholds& thresholds);
/// Arms each film of the foam that has grown to twice the T1 distance at it.
void rearm_grown_films(Foam& foam, const TopologyThresholds& thresholds);

}  // namespace foam
