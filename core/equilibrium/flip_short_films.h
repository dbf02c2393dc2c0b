// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/equilibrium/unknowns.h"
#include "core/foam/topology_thresholds.h"

#include <array>
#include <functional>

namespace foam {

/// The four bubbles around a film: on its left, on its right, beyond its tail and beyond its head.
using FourBubbles = std::array<BubbleId, 4>;

/// A function that flip_short_films calls after it has applied the T1 rule to a film. The arguments
/// are the film, the four bubbles that were around it, some of which may be the ghost, and whether
/// the network changed. If it changed, the film may be dead. If not, the film may still have been
/// reopened (reopen_film).
using OnT1Rule = std::function<void(FilmId, const FourBubbles&, bool)>;

/// Applies the T1 rule (core/foam/t1_rule.h) to the short films of a part of the foam. A film is
/// short if its chord is shorter than the T1 distance of the thresholds. Skips every film with an
/// end outside of the part. Calls `on_t1_rule` after each application. Erases dead ids from the
/// junctions, films and bubbles of the part, but updates neither the rank tables nor the
/// `outer_films` of the part. Returns the number of changes of the network.
int flip_short_films(Foam& foam,
                     Unknowns& part,
                     const TopologyThresholds& thresholds,
                     const OnT1Rule& on_t1_rule);

}  // namespace foam
