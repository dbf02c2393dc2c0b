// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/equilibrium/equilibrate.h"

#include <functional>

namespace foam {

/// Brings a foam that was made elsewhere to mechanical equilibrium (E2), in its own units. Its mean
/// bubble area and its film tension may have any value. Makes up to three attempts, until one
/// converges. The first two attempts keep the topology. The first one relaxes the whole foam (E4)
/// at its start only if the foam is tangled (untangle.h); the second one always does. The third
/// attempt allows T1s. Only the third attempt is made if T1s are due (short_films) at many films
/// from the start, as in a raw diagram. Many means more than five, and more than 1 % of all films.
/// The T1 distance is the default of TopologyThresholds, in units in which the mean bubble area,
/// without lone bubbles, is 1. If no attempt converges, the foam stays as it was given. The events
/// of the T1s are appended to the events of the foam.
///
/// In the summary, `iterations` and `sweeps` are sums over all attempts. All other members describe
/// the last attempt. The energy is in the units of the foam if this attempt converged, otherwise in
/// units of mean area 1 and film tension 1.
///
/// `threads` has the same meaning as in parallel_for; the result has the same bits for any number
/// of threads. `on_round` is EquilibriumOptions::on_round; if it throws, the foam stays as it was
/// given. Preconditions: the same as for `equilibrate`.
EquilibriumSummary equilibrate_given(Foam& foam,
                                     int threads,
                                     const std::function<void()>& on_round = {});

}  // namespace foam
