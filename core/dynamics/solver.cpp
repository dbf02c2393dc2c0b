// SPDX-License-Identifier: Apache-2.0

#include "core/dynamics/solver.h"

#include "core/reference/equilibrate_by_sweeps.h"

namespace foam {

EquilibriumSummary equilibrate_with(Solver solver, Foam& foam, const EquilibriumOptions& options) {
    switch (solver) {
        case Solver::GaussSeidel:
            return equilibrate_by_sweeps(foam, SweepOrder::Sequential, options);
        case Solver::ColoredGaussSeidel:
            return equilibrate_by_sweeps(foam, SweepOrder::Colored, options);
        case Solver::Newton:
            break;
    }
    return equilibrate(foam, options);
}

}  // namespace foam
