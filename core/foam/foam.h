#pragma once

#include "core/geometry/film_arc.h"
#include "core/geometry/torus.h"
#include "core/network/network.h"

#include <cstdint>

namespace foam {

/// The number under which a bubble is known from its birth to its end; never used again.
using BubbleIdentity = std::uint32_t;

/// A dry foam on a torus: the whole state, in foam units (the mean area of the seeded foam is 1).
/// Junctions lie in the torus' own cell, [0, width) x [0, height).
struct Foam {
    Torus torus;
    double film_tension = 1.0;  // T = 2 gamma
    double time = 0.0;          // foam time
    Network network;
    Indexed<JunctionId, Vec2> positions;
    Indexed<BubbleId, double> pressures;  // up to a common constant
    Indexed<BubbleId, double> target_areas;
    Indexed<BubbleId, BubbleIdentity> identities;
    BubbleIdentity next_identity = 0;
    // A film that has flipped is not armed until it has grown well above the T1 distance (E7), so
    // that a film whose two states are both short does not flip to and fro.
    Indexed<FilmId, std::uint8_t> t1_armed;
};

/// Head minus tail, around the torus.
Vec2 chord(const Foam& foam, HalfEdgeId h);

/// Pressure on the left less pressure on the right.
double pressure_difference(const Foam& foam, HalfEdgeId h);

/// The Laplace-Young arc of the half-edge (E1), its half angle held at the limit (kLargestSine).
FilmArc film_arc(const Foam& foam, HalfEdgeId h);

/// Moves the junction to a point anywhere in the plane, in its present frame, and wraps it.
void place_junction(Foam& foam, JunctionId junction, const Vec2& point);

/// Closes the gaps that vanished bubbles leave in every vector of the foam.
void compact(Foam& foam);

}  // namespace foam
