// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"

#include <optional>
#include <vector>

namespace foam {

/// Returns the bubble with the given identity. Returns nothing if the network has no such bubble,
/// for example because the bubble has vanished or is a lone bubble.
std::optional<BubbleId> find_bubble(const Foam& foam, BubbleIdentity identity);

/// Returns true if a bubble or a lone bubble has the given identity.
bool is_present(const Foam& foam, BubbleIdentity identity);

/// Returns the number of times that the outlines of a bubble and of all its lattice copies wind
/// counter-clockwise around a point of the plane: 1 if the point is inside one of them, 0 if it is
/// outside of all. If the bubble is inverted or overlaps its copies, other numbers are possible.
/// The sides of an outline are the arcs of the films. A point on a film may count as inside or
/// outside.
int winding_number(const Foam& foam, BubbleId bubble, const Vec2& point);

/// Returns the bubble that contains a point. The point may be anywhere in the plane, even if the
/// foam is on a torus. For a point on a film, returns a bubble beside the film. In a patch, returns
/// nothing if the point is in the ghost or in a lone bubble. But if a bubble of the network is
/// closer to this point than about 1e-6 foam units, may return that bubble. On a torus, returns the
/// first bubble if rounding errors hide which bubble contains the point. Precondition: no two
/// bubbles overlap.
std::optional<BubbleId> bubble_at(const Foam& foam, const Vec2& point);

/// Returns the identity of the bubble or lone bubble that contains a point, or nothing if no bubble
/// contains it.
std::optional<BubbleIdentity> identity_at(const Foam& foam, const Vec2& point);

/// Returns the live bubbles with the given number of sides, by increasing target area.
std::vector<BubbleId> bubbles_of_sides(const Foam& foam, int sides);

/// Returns the junction whose nearest lattice copy has the smallest distance from a point. The
/// point may be anywhere in the plane. If several junctions are equally near, returns the junction
/// with the smallest id. Precondition: there is a junction.
JunctionId nearest_junction(const Foam& foam, const Vec2& point);
/// Returns the film for which the nearest lattice copy of its chord has the smallest distance from
/// a point. The point may be anywhere in the plane. If several films are equally near, returns the
/// film with the smallest id. Precondition: there is a film.
FilmId nearest_film(const Foam& foam, const Vec2& point);

}  // namespace foam
