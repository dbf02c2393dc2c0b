// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"

#include <optional>
#include <vector>

namespace foam {

/// Returns the bubble with the given identity, or nothing if it has vanished or is a lone bubble.
std::optional<BubbleId> find_bubble(const Foam& foam, BubbleIdentity identity);

/// Returns how often the outline of a bubble and of all its lattice copies runs around a point of
/// the plane counter-clockwise: 1 inside, 0 outside. Films count as arcs. A point on a film may
/// count as inside or outside.
int winding_number(const Foam& foam, BubbleId bubble, const Vec2& point);

/// Returns the bubble that contains a point anywhere in the plane; for a point on a film, one of
/// the two bubbles beside it. Returns nothing outside of a patch and inside a lone bubble.
/// Precondition: no two bubbles overlap.
std::optional<BubbleId> bubble_at(const Foam& foam, const Vec2& point);

/// Returns the identity of the bubble that contains a point, including lone bubbles.
std::optional<BubbleIdentity> identity_at(const Foam& foam, const Vec2& point);

/// Returns the live bubbles with the given number of sides, by increasing target area.
std::vector<BubbleId> bubbles_of_sides(const Foam& foam, int sides);

/// Returns the junction nearest to a point anywhere in the plane; if several are equally near, the
/// junction with the smallest id. Precondition: there is a junction.
JunctionId nearest_junction(const Foam& foam, const Vec2& point);
/// Returns the film whose chord is nearest to a point anywhere in the plane; if several are equally
/// near, the film with the smallest id. Precondition: there is a film.
FilmId nearest_film(const Foam& foam, const Vec2& point);

}  // namespace foam
