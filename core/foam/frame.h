#pragma once

#include "core/foam/foam.h"

namespace foam {

/// A bubble at one instant, in foam units.
struct FrameBubble {
    BubbleIdentity identity = 0;
    double area = 0.0;  // within its arcs
    double target_area = 0.0;
    double pressure = 0.0;  // with the foam's constant, which an equilibrium sets (measure.h)
};

/// One instant of a foam, handed from the foam to the texture side; made once, then only read.
/// The network has no dead slots.
struct Frame {
    int number = 0;  // as in file names; the first is 1
    double time = 0.0;
    Domain domain;
    double film_tension = 1.0;
    Network network;
    Indexed<JunctionId, Vec2> positions;
    Indexed<FilmId, FilmArc> arcs;           // of the forward sides
    Indexed<BubbleId, FrameBubble> bubbles;  // the ghost, the network's last, is none of them
    std::vector<LoneBubble> lone_bubbles;

    /// The arc as walked along a half-edge.
    FilmArc arc(HalfEdgeId h) const {
        const FilmArc& forward = arcs[film_of(h)];
        return is_forward(h) ? forward : reversed(forward);
    }
};

Frame snapshot(const Foam& foam, int number);

}  // namespace foam
