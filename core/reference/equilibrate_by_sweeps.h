// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/equilibrium/equilibrate.h"
#include "core/reference/gauss_seidel.h"

namespace foam {

/// Brings the foam to mechanical equilibrium like `equilibrate`, but by the paper's solver (E5)
/// instead of Newton's method. Relaxes the foam first if it is tangled
/// (core/equilibrium/untangle.h) or if EquilibriumOptions::relaxes_first is set. Then runs rounds
/// until no T1 is due; a round consists of Gauss-Seidel sweeps (gauss_seidel) and the T1s of short
/// films. Stops without equilibrium if the sweeps of a round reach their limit
/// (GaussSeidelOptions::max_sweeps), or after EquilibriumOptions::max_rounds rounds. Returns the
/// same summary as `equilibrate`; `iterations` is the number of Gauss-Seidel sweeps. Preconditions:
/// the same as for `equilibrate`.
EquilibriumSummary equilibrate_by_sweeps(Foam& foam,
                                         SweepOrder order,
                                         const EquilibriumOptions& options);

}  // namespace foam
