// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/topology_event.h"
#include "core/geometry/domain.h"
#include "core/geometry/film_arc.h"
#include "core/network/network.h"

#include <vector>

namespace foam {

/// A bubble of a patch that touches no other bubble: a circle, which is not part of the network.
struct LoneBubble {
    BubbleIdentity identity = 0;
    Vec2 center{0.0, 0.0};
    double target_area = 0.0;  // equal to its area

    friend bool operator==(const LoneBubble& a, const LoneBubble& b) = default;
};

/// The whole state of a dry foam, in foam units (the mean bubble area of a seeded foam is 1). On a
/// torus, the positions of all junctions are in the fundamental cell, [0, width) x [0, height), up
/// to rounding (geometry/domain.h). E1 and E7 are equations in core/EQUATIONS.md.
///
/// A patch is in the plane and has a ghost bubble, which represents the atmosphere. The pressure of
/// the ghost is 0. Its target area is infinite, because the atmosphere gives and takes any amount
/// of gas.
struct Foam {
    Domain domain;
    double film_tension = 1.0;  // T = 2 gamma
    double time = 0.0;          // foam time (core/README.md)
    Network network;
    Indexed<JunctionId, Vec2> positions;
    Indexed<BubbleId, double> pressures;  // on a torus determined only up to a common constant
    Indexed<BubbleId, double> target_areas;
    Indexed<BubbleId, BubbleIdentity> identities;
    BubbleIdentity next_identity = 0;  // for the next new bubble
    // 0 for a film that has flipped and since then has not grown to twice its full T1 distance
    // (E7), otherwise 1. The flag keeps a film from flipping to and fro if it is short both before
    // and after a flip.
    Indexed<FilmId, std::uint8_t> t1_armed;
    // The half angles of the outer films of a patch, in radians, in the direction of the forward
    // sides. The magnitude of a half angle is less than pi. The entries of inner films are unused,
    // because their half angles follow from the pressures. Empty on a torus.
    Indexed<FilmId, double> half_angles;
    std::vector<LoneBubble> lone_bubbles;  // only in a patch; by increasing identity
    // The topology events since the list was last cleared, in the order in which they happened. The
    // list is not part of the physical state.
    std::vector<TopologyEvent> events;
};

/// Returns the vector from the tail to the head of the half-edge. On a torus, it leads to the
/// lattice copy of the head at which the half-edge ends (Network::offset).
Vec2 chord(const Foam& foam, HalfEdgeId h);

/// Returns the midpoint of the chord of the film: the position of the tail of its forward side plus
/// half of its chord. On a torus, the midpoint may be outside of the fundamental cell.
Vec2 middle_of(const Foam& foam, FilmId film);

/// Returns the pressure on the left of the half-edge minus the pressure on its right.
double pressure_difference(const Foam& foam, HalfEdgeId h);

/// Returns the arc along the half-edge (E1). The half angle of an outer film is taken from
/// Foam::half_angles. The half angle of an inner film follows from Laplace-Young's law and is
/// clamped to 80 degrees (kLargestSine).
FilmArc film_arc(const Foam& foam, HalfEdgeId h);

/// Sets the half angle of an outer film to `angle`, in radians, in the direction of the half-edge.
/// The magnitude is clamped to slightly less than pi.
void set_half_angle(Foam& foam, HalfEdgeId h, double angle);

/// Sets the half angle of an outer film by Laplace-Young's law, clamped to 80 degrees
/// (kLargestSine). Does nothing to an inner film.
void fit_half_angle(Foam& foam, FilmId film);

/// Makes the foam a patch: sets the domain to the plane, appends the values of the ghost, and fits
/// the half angles of all outer films. The values of the ghost are its pressure, target area and
/// identity. Precondition: the last bubble of the network is a new ghost, for which the foam has no
/// values yet.
void complete_patch(Foam& foam);

/// Moves the junction to a point of the plane. On a torus, the point may be outside of the
/// fundamental cell. The function then wraps the junction into the cell and updates the lattice
/// offsets of the junction's films. Precondition: the point is the stored position of the junction
/// plus the displacement of the move, not wrapped. Another lattice copy of this point would stretch
/// the films across the torus.
void place_junction(Foam& foam, JunctionId junction, const Vec2& point);

/// Moves all junctions by the same vector. Lone bubbles are not moved.
void translate(Foam& foam, const Vec2& displacement);

/// Renumbers the elements of the network, and reorders every vector of the foam that is indexed by
/// their ids. Removes all dead slots. Precondition: the same as for Network::renumber.
void renumber(Foam& foam, const Network::OldIds& order);

/// Removes the dead slots from the network and from every vector of the foam that is indexed by
/// ids. The elements keep their order, except that the ghost becomes the last bubble.
void compact(Foam& foam);

}  // namespace foam
