#pragma once

#include "core/foam/topology_event.h"
#include "core/geometry/domain.h"
#include "core/geometry/film_arc.h"
#include "core/network/network.h"

#include <vector>

namespace foam {

/// A bubble of a patch that touches no other: a circle, outside of the network.
struct LoneBubble {
    BubbleIdentity identity = 0;
    Vec2 centre{0.0, 0.0};
    double target_area = 0.0;  // which it has

    friend bool operator==(const LoneBubble& a, const LoneBubble& b) = default;
};

/// A dry foam: the whole state, in foam units (the mean area of the seeded foam is 1). On a torus,
/// junctions lie in the torus' own cell, [0, width) x [0, height).
///
/// A patch lies in the plane and has a ghost, whose pressure is 0 and whose target area is
/// infinite: the atmosphere gives and takes any amount.
struct Foam {
    Domain domain;
    double film_tension = 1.0;  // T = 2 gamma
    double time = 0.0;          // foam time
    Network network;
    Indexed<JunctionId, Vec2> positions;
    Indexed<BubbleId, double> pressures;  // on a torus up to a common constant
    Indexed<BubbleId, double> target_areas;
    Indexed<BubbleId, BubbleIdentity> identities;
    BubbleIdentity next_identity = 0;
    // A film that has flipped is not armed until it has grown well above the T1 distance (E7), so
    // that a film whose two states are both short does not flip to and fro.
    Indexed<FilmId, std::uint8_t> t1_armed;
    // Of a patch: the half angles of the outer films along their forward sides, in (-pi, pi); those
    // of other films follow from the pressures, and have a place here without a meaning.
    Indexed<FilmId, double> half_angles;
    std::vector<LoneBubble> lone_bubbles;  // of a patch, by increasing identity
    // Since they were last cleared, which is up to whoever reads them; in their order. No part of
    // the physical state.
    std::vector<TopologyEvent> events;
};

/// Head minus tail, around the torus.
Vec2 chord(const Foam& foam, HalfEdgeId h);

/// Of the film's chord, unwrapped from its forward tail.
Vec2 middle_of(const Foam& foam, FilmId film);

/// Pressure on the left less pressure on the right.
double pressure_difference(const Foam& foam, HalfEdgeId h);

/// The Laplace-Young arc of the half-edge (E1), its half angle held at the limit (kLargestSine); of
/// an outer film the arc of the half angle that it has.
FilmArc film_arc(const Foam& foam, HalfEdgeId h);

/// Sets the half angle of an outer film, along the half-edge, held within (-pi, pi).
void set_half_angle(Foam& foam, HalfEdgeId h, double angle);

/// Gives an outer film the half angle of Laplace-Young, held at the limit. Others stay as they are.
void fit_half_angle(Foam& foam, FilmId film);

/// Adds the ghost's values to a foam whose network has just got one, as the last of its bubbles,
/// and fits the half angles of all outer films.
void complete_patch(Foam& foam);

/// Moves the junction to a point anywhere in the plane, in its present frame, and wraps it.
void place_junction(Foam& foam, JunctionId junction, const Vec2& point);

/// Moves all junctions by the same. Lone bubbles stay.
void translate(Foam& foam, const Vec2& by);

/// Closes the gaps that vanished bubbles leave in every vector of the foam.
void compact(Foam& foam);

}  // namespace foam
