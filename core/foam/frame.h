// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"

namespace foam {

/// A bubble of the network at one instant, in foam units.
struct FrameBubble {
    BubbleIdentity identity = 0;
    double area = 0.0;  // area within the arcs of the bubble
    double target_area = 0.0;
    double pressure = 0.0;  // on a torus determined only up to a common constant
};

/// One instant of a foam: an immutable snapshot, the input of the texture generator. The network
/// has no dead slots.
struct Frame {
    int number = 0;  // used in file names; the first frame is 1
    double time = 0.0;
    Domain domain;
    double film_tension = 1.0;
    Network network;
    Indexed<JunctionId, Vec2> positions;
    Indexed<FilmId, FilmArc> arcs;           // the arc of each film along its forward side
    Indexed<BubbleId, FrameBubble> bubbles;  // without the ghost, which is last in the network
    std::vector<LoneBubble> lone_bubbles;

    /// Returns the arc of a film in the direction of the half-edge.
    FilmArc arc(HalfEdgeId h) const {
        const FilmArc& forward = arcs[film_of(h)];
        return is_forward(h) ? forward : reversed(forward);
    }
};

/// Returns the present state of the foam as the frame with the given number.
Frame snapshot(const Foam& foam, int number);

/// Returns a foam in the state of the frame, with an empty list of topology events. The flags
/// Foam::t1_armed of all films are 1, because a frame does not contain these flags. For the same
/// reason, Foam::next_identity is one more than the largest identity in the frame.
Foam foam_of(const Frame& frame);

}  // namespace foam
