#pragma once

#include "core/foam/t1_rule.h"
#include "core/equilibrium/unknowns.h"

#include <array>
#include <functional>

namespace foam {

using FourBubbles = std::array<BubbleId, 4>;

/// Called with a film that was short, the bubbles that were around it, the ghost among them, and
/// whether the network changed: each of these may have gone then. If not, the film may still have
/// been laid anew.
using OnSettled = std::function<void(FilmId, const FourBubbles&, bool)>;

/// The T1s that are due (settle_film) at the films of a part that are shorter than the T1 distance,
/// and have both ends in it. Takes what is gone from the part. Returns the number of T1s.
int settle_short_films(Foam& foam,
                       Unknowns& part,
                       const TopologyThresholds& thresholds,
                       Tangents tangents,
                       const OnSettled& on_settled);

}  // namespace foam
