// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"

namespace foam {

/// A bubble at one instant, in foam units.
struct FrameBubble {
    BubbleIdentity identity = 0;
    double area = 0.0;  // within its arcs
    double target_area = 0.0;
    double pressure = 0.0;  // on a torus up to a constant (center_pressures in measure.h)
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
    Indexed<FilmId, FilmArc> arcs;           // of the forward sides
    Indexed<BubbleId, FrameBubble> bubbles;  // no entry for the ghost, the network's last bubble
    std::vector<LoneBubble> lone_bubbles;

    /// Returns the arc of a film in the direction of the half-edge.
    FilmArc arc(HalfEdgeId h) const {
        const FilmArc& forward = arcs[film_of(h)];
        return is_forward(h) ? forward : reversed(forward);
    }
};

/// Returns the present state of the foam as the frame of the given number.
Frame snapshot(const Foam& foam, int number);

}  // namespace foam
