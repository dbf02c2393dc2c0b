// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"

#include <optional>

namespace foam {

/// Replaces a junction by a new three-sided bubble with the given target area, and returns the
/// bubble (E10). Its corners are on the films that met at the junction. In equilibrium these films
/// still point at the point where they would meet at 120 degrees, so that the rest of the foam
/// hardly moves. The gas comes from the surrounding bubbles in proportion to their target areas; at
/// the surface of a patch, from the atmosphere alone. Returns nothing and changes nothing if the
/// surrounding bubbles have less than twice the area. Leaves the foam near equilibrium.
/// Precondition: the area is positive.
std::optional<BubbleId> nucleate_at_junction(Foam& foam, JunctionId junction, double area);

/// Adds a new two-sided bubble, a lens, in the middle of a film, and returns it (E10). It touches
/// only the two bubbles beside the film, as a small bubble does. Gas, failure and precondition are
/// those of nucleate_at_junction. Equilibrium does not determine where along the film the bubble
/// rests.
std::optional<BubbleId> nucleate_on_film(Foam& foam, FilmId film, double area);

}  // namespace foam
