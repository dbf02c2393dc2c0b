#pragma once

#include "core/foam/foam.h"
#include "core/foam/topology_thresholds.h"

#include <span>
#include <vector>

namespace foam {

/// The T1 distance at a film: the threshold, scaled down to the smallest of the four bubbles around
/// it where that is smaller than 1, and tenfold shorter for a film that has flipped and not grown
/// since (E7).
double t1_length(const Foam& foam, FilmId film, const TopologyThresholds& thresholds);

/// Below this length a film is as good as a point where four films meet.
double collapsed_length(const Foam& foam, FilmId film, const TopologyThresholds& thresholds);

/// How the tangents of a film's outer films are taken.
enum class Tangents {
    OfArcs,
    OfChords,  // while films are straight (E4)
};

/// Whether the outer films would pull the flipped film apart: their mean pull along it exceeds the
/// pull of the film itself, if there is one between them.
bool flipped_pulls_apart(const Foam& foam, FilmId film, Tangents tangents);

/// Flips the film (t1.h), sets its junctions perpendicular to the old film around its middle at the
/// same distance (paper 3), and disarms it. Precondition: can_flip.
void flip_film(Foam& foam, FilmId film);

/// Opens a film that has collapsed to a point of four films: lays it, with the given length, in the
/// direction in which its outer films pull the hardest, flipped or not. Returns whether it was
/// flipped.
bool reopen_film(Foam& foam, FilmId film, double length, Tangents tangents);

/// Whether the film has the ghost at both ends (split.h), and neither of its bubbles comes loose
/// with it: one of two sides is held by it at any size.
bool can_tear(const Network& network, FilmId film);

/// Whether the film can flip or tear.
bool can_change(const Network& network, FilmId film);

/// The T1 that is due at a short film, if any: a collapsed film is opened anew, another one flipped
/// where its flipped state stays open. With the ghost at both ends it tears instead, as nothing
/// holds what would be the flipped film together; and a hole that it goes around is closed where it
/// is small, and loses the film where the bubbles around it overlap.
/// Returns whether the network changed; the film may then be gone.
bool settle_film(Foam& foam, FilmId film, const TopologyThresholds& thresholds, Tangents tangents);

/// Films below their T1 distance that would stay open when flipped, or torn, in increasing order.
std::vector<FilmId> short_films(const Foam& foam, const TopologyThresholds& thresholds);

/// Arms every one of the films that has grown to twice its T1 distance.
void rearm_grown_films(Foam& foam,
                       std::span<const FilmId> films,
                       const TopologyThresholds& thresholds);
/// The same for all films.
void rearm_grown_films(Foam& foam, const TopologyThresholds& thresholds);

}  // namespace foam
