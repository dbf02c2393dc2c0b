#pragma once

#include "core/equilibrium/unknowns.h"
#include "core/foam/topology_thresholds.h"

#include <array>
#include <functional>

namespace foam {

using FourBubbles = std::array<BubbleId, 4>;

/// Called after the T1 rule has been applied to a film, with the four bubbles that were around it,
/// the ghost possibly among them, and with whether the network changed. If it did, the film and
/// each of the bubbles may have gone; if not, the film may still have been opened anew.
using OnT1Rule = std::function<void(FilmId, const FourBubbles&, bool)>;

/// Applies the T1 rule to the films of a part of the foam that are shorter than the T1 distance and
/// have both ends in the part. Removes what has gone from the part. Returns the number of T1s.
int flip_short_films(Foam& foam,
                     Unknowns& part,
                     const TopologyThresholds& thresholds,
                     const OnT1Rule& on_t1_rule);

}  // namespace foam
