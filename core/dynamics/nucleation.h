// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"

#include <optional>

namespace foam {

/// Replaces a junction by a new three-sided bubble with the given target area, and returns the
/// bubble (E10). Its corners are on the films that met at the junction. In equilibrium these films
/// still point at the point where they would meet at 120 degrees, so that the rest of the foam
/// hardly moves. The gas comes from the surrounding bubbles in proportion to their target areas; at
/// the surface of a patch, it comes from the atmosphere alone. Returns nothing and changes nothing
/// if the target areas of the surrounding bubbles add up to less than twice the given area. Leaves
/// the foam near equilibrium. Precondition: the area is positive.
std::optional<BubbleId> nucleate_at_junction(Foam& foam, JunctionId junction, double area);

/// Adds a new two-sided bubble, a lens, in the middle of a film, and returns it (E10). The bubble
/// touches only the two bubbles beside the film. The source of the gas, the failure case and the
/// precondition are the same as for nucleate_at_junction. Equilibrium does not determine the
/// position of the bubble along the film.
std::optional<BubbleId> nucleate_on_film(Foam& foam, FilmId film, double area);

}  // namespace foam
