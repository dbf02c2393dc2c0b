#pragma once

#include "core/equilibrium/equilibrate.h"

namespace foam {

/// Brings a foam that was made elsewhere to mechanical equilibrium (E2), in its own units: its mean
/// bubble area and its film tension may have any value. Keeps the topology if that leads to an
/// equilibrium, by Newton's method alone or else after relaxation; otherwise it allows T1s, at the
/// default T1 distance for a mean area of 1. The counts of the summary are those of the attempt
/// that is kept, except `iterations` and `sweeps`, which are sums over all. If no attempt
/// converges, the foam stays as it was given. `threads` as in parallel_for; the bits are the same
/// for any number. Preconditions: as of equilibrate.
EquilibriumSummary equilibrate_given(Foam& foam, int threads);

}  // namespace foam
