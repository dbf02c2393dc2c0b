// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/frame.h"
#include "texgen/maps/arc_distance.h"

#include <span>
#include <vector>

namespace foam::texgen {

/// A point of the line through the solution of a maze. It is a point where the line crosses a film,
/// an end of the line, or a point that `refined` has inserted.
struct Station {
    Vec2 position{0.0, 0.0};   // foam units; not wrapped into the fundamental cell of a torus
    Vec2 direction{0.0, 0.0};  // direction of the line at `position`, a unit vector
};

/// Returns the points at which the line of solution_line (below) crosses films, and on a torus also
/// both ends of the line. Precondition: `path` is not empty.
std::vector<Station> solution_stations(const Frame& frame, std::span<const HalfEdgeId> path);

/// Divides the cubic curve between each two successive stations into `pieces` pieces, by equal
/// steps of its parameter. Returns the given stations and the new ones between them. Precondition:
/// `stations` is not empty, pieces > 0.
std::vector<Station> refined(std::span<const Station> stations, int pieces);

/// Returns a smooth line through bubbles as a chain of short straight pieces. `path` lists the
/// films that the line crosses, as half-edges that it crosses from left to right. The bubble on the
/// right of each half-edge is on the left of the next half-edge. The line crosses each film in its
/// middle and at a right angle; between two films it is a cubic curve. On a torus, the line begins
/// at the mean of the corners of the first bubble. It ends at the mean of the corners of the last
/// bubble. On a patch, it begins in the middle of the first film and ends in the middle of the last
/// film. If `path` is empty, the line has no pieces. `scale` is in pixels per foam unit.
std::vector<PlacedArc> solution_line(const Frame& frame,
                                     std::span<const HalfEdgeId> path,
                                     double scale);

}  // namespace foam::texgen
