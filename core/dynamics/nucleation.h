#pragma once

#include "core/foam/foam.h"

#include <optional>

namespace foam {

/// A new bubble of a target area, above 0, in the place of a junction: three-sided, its corners on
/// the films that met there. In equilibrium these films go on towards the point where they would
/// meet at 120 degrees, so that the rest of the foam hardly notices. Its gas comes from the bubbles
/// around it in proportion to their target areas, at the surface of a patch from the atmosphere
/// alone; nothing, and no change, where there is not twice as much. Leaves the foam near
/// equilibrium.
std::optional<BubbleId> nucleate_at_junction(Foam& foam, JunctionId junction, double area);

/// The same on the middle of a film, as a two-sided lens: it touches the two bubbles beside the
/// film alone, as a small bubble does. Where along the film it rests is left open by equilibrium.
std::optional<BubbleId> nucleate_on_film(Foam& foam, FilmId film, double area);

}  // namespace foam
