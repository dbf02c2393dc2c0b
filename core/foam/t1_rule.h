// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"
#include "core/foam/topology_thresholds.h"

#include <span>
#include <vector>

namespace foam {

/// Applies the T1 rule (E7 in core/EQUATIONS.md). The rule decides whether a film flips, tears or
/// is reopened, or whether the hole beside the film closes. The function then performs the change.
/// The functions that change the network are in core/network (t1.h, split.h, t2.h) and rafts.h. The
/// first case that applies is decisive:
/// - A film that can tear (can_tear) tears or does not change. It never flips, because the flipped
///   film would have the ghost on both sides. It tears if it is shorter than its T1 distance
///   (t1_distance_at) and its neighboring films would pull its two sides apart
///   (would_stay_open). It also tears if it has collapsed (collapsed_length) and its
///   neighboring films pull hard enough. Their pull across it must exceed their pull along it minus
///   the tension of the film.
/// - If an outer film is at a small hole (is_small_hole with the T1 distance of the thresholds),
///   the hole closes, if it can.
/// - If an outer film is at a hole in which bubbles overlap (is_overlapping_hole), the hole closes
///   if it can. If the hole cannot close, the film flips if it can. This case does not depend on
///   the length of the film, so callers must apply the rule only to films that they consider short.
/// - A collapsed film (collapsed_length) is reopened (reopen_film).
/// - Any other film that is shorter than its T1 distance (t1_distance_at) flips if it can and if it
///   would stay open afterwards (would_stay_open).
///
/// Returns true if the network changed. In this case, the film may have been removed.
bool apply_t1_rule(Foam& foam, FilmId film, const TopologyThresholds& thresholds);

/// Applies the T1 rule to the films in their order, except to films that an earlier change has
/// removed. Returns the number of changes of the network.
int apply_t1_rule(Foam& foam, std::span<const FilmId> films, const TopologyThresholds& thresholds);

/// Returns, by increasing id, the films that are shorter than their T1 distance (t1_distance_at),
/// can flip or tear, and would stay open afterwards (would_stay_open).
std::vector<FilmId> short_films(const Foam& foam, const TopologyThresholds& thresholds);

/// Returns the T1 distance of the film, the chord length below which the film may flip: the T1
/// distance of the thresholds, multiplied by two factors. If the smallest target area of the four
/// bubbles around the film is below 1, the first factor is the square root of this area, otherwise
/// 1. The second factor is 0.1 for a disarmed film (Foam::t1_armed), otherwise 1.
double t1_distance_at(const Foam& foam, FilmId film, const TopologyThresholds& thresholds);

/// Returns the chord length below which the film counts as collapsed to a point where four films
/// meet: 5 % of the T1 distance that the film has when it is armed (t1_distance_at), even if it is
/// disarmed.
double collapsed_length(const Foam& foam, FilmId film, const TopologyThresholds& thresholds);

/// Returns true if the film would stay open after a flip. At each end of the flipped film, two
/// neighboring films pull outward. The film stays open if the mean of the pulls at both ends, along
/// the flipped film, exceeds the tension of the flipped film. If the film can tear, the threshold
/// is 0 instead, because after tearing no film pulls the two sides together.
bool would_stay_open(const Foam& foam, FilmId film);

/// Flips the film (t1.h), records a T1 and disarms the film (Foam::t1_armed). The chord of the
/// flipped film is the old chord, rotated clockwise by 90 degrees around its midpoint (paper
/// section 3). Precondition: can_flip.
void flip_film(Foam& foam, FilmId film);

/// Opens a film that has collapsed to a point where four films meet. Flips the film if it can flip
/// and if the four neighboring films would pull harder on the flipped film than on the present
/// film. Gives the film the direction of the pull (of the x axis if the pull is zero) and the given
/// chord length, and keeps its midpoint. A flip is recorded as a T1 and disarms the film, as in
/// flip_film. Returns true if the film was flipped.
bool reopen_film(Foam& foam, FilmId film, double length);

/// Returns true if the film has the ghost at both ends (split.h) and both bubbles beside it have
/// more than two sides. A bubble of two sides is stable at any size, so its film does not tear.
bool can_tear(const Network& network, FilmId film);

/// Returns true if the film can flip or tear.
bool can_change(const Network& network, FilmId film);

/// Arms each of the given films that is disarmed (Foam::t1_armed) and has grown. A film has grown
/// if its chord is longer than twice the T1 distance that the film has when it is armed
/// (t1_distance_at).
void rearm_grown_films(Foam& foam,
                       std::span<const FilmId> films,
                       const TopologyThresholds& thresholds);
/// Arms each disarmed film of the foam under the same condition.
void rearm_grown_films(Foam& foam, const TopologyThresholds& thresholds);

}  // namespace foam
