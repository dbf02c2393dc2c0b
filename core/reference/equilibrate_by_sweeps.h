// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/equilibrium/equilibrate.h"
#include "core/reference/gauss_seidel.h"

namespace foam {

/// Brings the foam to mechanical equilibrium as `equilibrate` does, but by the paper's solver (E5)
/// in place of Newton's method. Relaxes the foam first if it is tangled or if the options ask for
/// it. Then runs rounds of Gauss-Seidel, each followed by the T1s that are due in equilibrium.
/// Preconditions: those of `equilibrate`.
EquilibriumSummary equilibrate_by_sweeps(Foam& foam,
                                         SweepOrder order,
                                         const EquilibriumOptions& options);

}  // namespace foam
