#pragma once

#include "core/foam/foam.h"

#include <optional>

namespace foam {

/// Replaces a junction by a new three-sided bubble of a target area above 0, with its corners on
/// the films that met there. In equilibrium these films still point at the point where they would
/// meet at 120 degrees, so that the rest of the foam hardly moves. The gas comes from the bubbles
/// around in proportion to their target areas, at the surface of a patch from the atmosphere alone.
/// Returns nothing, and changes nothing, if these bubbles do not have twice as much. Leaves the
/// foam near equilibrium.
std::optional<BubbleId> nucleate_at_junction(Foam& foam, JunctionId junction, double area);

/// The same on the middle of a film, as a two-sided lens: it touches only the two bubbles beside
/// the film, as a small bubble does. Equilibrium leaves open where along the film it rests.
std::optional<BubbleId> nucleate_on_film(Foam& foam, FilmId film, double area);

}  // namespace foam
