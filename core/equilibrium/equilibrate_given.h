#pragma once

#include "core/equilibrium/equilibrate.h"

namespace foam {

/// Brings a foam that was made elsewhere to mechanical equilibrium (E2), in its own units: its mean
/// bubble area and its film tension may have any value. Keeps the topology where that leads to an
/// equilibrium, by Newton's method alone or else after relaxation; only then T1s are allowed, at
/// the default T1 distance for a mean area of 1. The summary's counts are of the attempt that is
/// kept, but for `iterations` and `sweeps`, which are of all. Where it has not converged, the foam
/// is as it was given. Any number of threads gives the same bits; 0: as many as run at once.
/// Preconditions: as of equilibrate.
EquilibriumSummary equilibrate_given(Foam& foam, int threads);

}  // namespace foam
