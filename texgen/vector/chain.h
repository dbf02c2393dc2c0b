// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/geometry/film_arc.h"

#include <cstdint>
#include <span>
#include <vector>

namespace foam::texgen {

/// An arc of a drawing. Lengths are in millimeters, y points up.
struct DrawnArc {
    Vec2 tail{0.0, 0.0};
    Vec2 head{0.0, 0.0};
    double half_angle = 0.0;  // FilmArc::half_angle

    FilmArc arc() const { return {head - tail, half_angle}; }
};

/// Returns the same arc in the direction from head to tail.
inline DrawnArc reversed(const DrawnArc& arc) {
    return {arc.head, arc.tail, -arc.half_angle};
}

/// A sequence of arcs, each of which begins where the one before it ends. A closed chain ends where
/// it begins.
struct Chain {
    Vec2 tail{0.0, 0.0};  // start of the first arc, in millimeters
    // An arc that begins where the arc before it ends.
    struct Step {
        Vec2 head{0.0, 0.0};
        double half_angle = 0.0;
    };
    std::vector<Step> steps;
    bool is_closed = false;

    const Vec2& head() const { return steps.empty() ? tail : steps.back().head; }
};

/// Returns the arcs of a chain.
std::vector<DrawnArc> arcs_of(const Chain& chain);

/// Returns the chain of the given arcs. Precondition: each arc begins where the one before it ends.
Chain chain_of(std::span<const DrawnArc> arcs, bool is_closed);

/// Returns the same chain in the opposite direction.
Chain reversed(const Chain& chain);

/// Returns the area inside a closed chain: the sum of the areas between its arcs and a point
/// (Green's theorem). The area is negative if the chain is clockwise.
double signed_area(const Chain& chain);

/// Returns the centroid of the region inside a closed chain whose area is not zero.
Vec2 centroid(const Chain& chain);

/// A rectangle whose sides are parallel to the axes.
struct Box {
    Vec2 low{0.0, 0.0};
    Vec2 high{0.0, 0.0};
};

/// Enlarges a box so that it contains a chain. Arcs may extend beyond the box by up to 1 % of their
/// largest distance from their chord.
void include(const Chain& chain, Box& box);

/// Returns a full circle, counter-clockwise, as two arcs.
Chain circle(const Vec2& center, double radius);

/// An arc between two nodes of a net of lines. Arcs are joined where they share a node.
struct NetArc {
    DrawnArc arc;
    std::uint64_t tail_node = 0;
    std::uint64_t head_node = 0;
};

/// Joins the arcs of a net into chains, in which every arc occurs once. One open chain ends at each
/// node at which an odd number of arcs end, and none at the other nodes. The result depends only on
/// the arcs and their order.
std::vector<Chain> joined(std::span<const NetArc> arcs);

}  // namespace foam::texgen
