// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/equilibrium/equilibrate.h"
#include "core/reference/gauss_seidel.h"

namespace foam {

/// Brings the foam to mechanical equilibrium like `equilibrate`, but by the paper's solver (E5)
/// instead of Newton's method. Relaxes the foam first if it is tangled or if
/// EquilibriumOptions::relaxes_first is set. Then runs rounds of Gauss-Seidel, each followed by the
/// T1s of short films. Preconditions: the same as for `equilibrate`.
EquilibriumSummary equilibrate_by_sweeps(Foam& foam,
                                         SweepOrder order,
                                         const EquilibriumOptions& options);

}  // namespace foam
