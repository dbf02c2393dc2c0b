// SPDX-License-Identifier: Apache-2.0

#include "texgen/animation/displaced_frame.h"

#include "core/geometry/elementary.h"

namespace foam::texgen {

// The half angle of an arc through three points is easy to compute. The chords from the first point
// to the second and from the second point to the third form a path. The half angle equals the angle
// by which this path turns left at the second point (inscribed angle theorem).
Frame displaced(Frame frame,
                const Indexed<JunctionId, Vec2>& junction_displacements,
                const Indexed<FilmId, Vec2>& middle_displacements) {
    Network& network = frame.network;
    for (const FilmId film : network.films()) {
        FilmArc& arc = frame.arcs[film];
        const Vec2& tail_displacement = junction_displacements[network.tail(forward_side(film))];
        const Vec2& head_displacement = junction_displacements[network.head(forward_side(film))];
        const Vec2 first = point_at(arc, 0.5) + middle_displacements[film] - tail_displacement;
        const Vec2 chord = arc.chord + head_displacement - tail_displacement;
        const Vec2 second = chord - first;
        arc = {chord, ieee::atan2(cross(first, second), first.dot(second))};
    }
    for (const JunctionId junction : network.junctions()) {
        const Vec2 position = frame.positions[junction] + junction_displacements[junction];
        const LatticeOffset cell = frame.domain.cell_of(position);
        frame.positions[junction] = position - frame.domain.translation(cell);
        if (cell != LatticeOffset{}) {
            network.rebase(junction, cell);
        }
    }
    return frame;
}

Vec2 mean_corner(const Frame& frame, BubbleId bubble) {
    const Network& network = frame.network;
    Vec2 corner = frame.positions[network.tail(network.first(bubble))];
    Vec2 sum = Vec2::Zero();
    for (const HalfEdgeId h : network.around(bubble)) {
        sum += corner;
        corner += frame.arc(h).chord;
    }
    return sum / network.sides(bubble);
}

}  // namespace foam::texgen
