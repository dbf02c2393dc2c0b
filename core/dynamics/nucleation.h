// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"

#include <optional>

namespace foam {

/// Replaces a junction by a new three-sided bubble with the given target area (E10). Returns the
/// bubble. The corners of the bubble are on the films that met at the junction. In equilibrium, the
/// extensions of these films into the bubble still meet at one point at 120 degrees. The rest of
/// the foam therefore hardly moves. The gas of the new bubble comes from the surrounding bubbles in
/// proportion to their target areas. At the surface of a patch, all of it comes from the ghost.
/// Returns nothing and changes nothing if the target areas of the surrounding bubbles add up to
/// less than twice the given area. Leaves the foam near equilibrium. The bubble gets a new identity
/// unless `identity` is given. Preconditions: the area is positive; the given identity is less than
/// Foam::next_identity, and no bubble of the foam has it.
std::optional<BubbleId> nucleate_at_junction(Foam& foam,
                                             JunctionId junction,
                                             double area,
                                             std::optional<BubbleIdentity> identity = {});

/// Adds a new two-sided bubble, a lens, in the middle of a film (E10). Returns the bubble. The
/// bubble touches only the two bubbles beside the film. Takes the gas from these two bubbles in
/// proportion to their target areas. At the surface of a patch, all of it comes from the ghost.
/// Returns nothing and changes nothing if the target areas of the two bubbles add up to less than
/// twice the given area. Equilibrium does not determine the position of the new bubble along the
/// film. Precondition: the area is positive.
std::optional<BubbleId> nucleate_on_film(Foam& foam, FilmId film, double area);

}  // namespace foam
