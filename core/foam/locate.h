#pragma once

#include "core/foam/foam.h"

#include <optional>
#include <vector>

namespace foam {

/// The live bubble of an identity; nothing once it has vanished.
std::optional<BubbleId> find_bubble(const Foam& foam, BubbleIdentity identity);

/// How often the outline of a bubble, arcs and all its lattice copies, runs around a point of the
/// plane counter-clockwise: 1 inside, 0 outside. A point on a film counts for either side.
int winding_number(const Foam& foam, BubbleId bubble, const Vec2& point);

/// The bubble that holds a point anywhere in the plane; on a film, one of those beside it. Nothing
/// outside of a patch, and in a lone bubble. Precondition: no two bubbles overlap.
std::optional<BubbleId> bubble_at(const Foam& foam, const Vec2& point);

/// The identity of the bubble that holds a point, be it a lone one.
std::optional<BubbleIdentity> identity_at(const Foam& foam, const Vec2& point);

/// The live bubbles of so many sides, those of the smallest target area first.
std::vector<BubbleId> bubbles_of_sides(const Foam& foam, int sides);

/// The junction nearest to a point anywhere in the plane, and the film whose chord is nearest.
/// Where several are, the one of the smallest id. Precondition: there are some.
JunctionId nearest_junction(const Foam& foam, const Vec2& point);
FilmId nearest_film(const Foam& foam, const Vec2& point);

}  // namespace foam
