// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/topology_thresholds.h"

namespace foam {

/// Options of `equilibrate` and of solvers that take its place.
struct EquilibriumOptions {
    TopologyThresholds thresholds{};
    // The equilibrium is accepted if the errors of the foam are below this
    // (EquilibriumErrors::are_below). Gauss-Seidel also stops there; it is very slow below 1e-4.
    double tolerance = 1e-9;
    bool relaxes_first = true;  // relaxes the foam first (E4), for a foam far from equilibrium
    // Sweeps of the first relaxation, and of relaxations after a stall of Newton's method.
    int relaxation_sweeps = 60;
    int threads = 0;       // same meaning as in parallel_for; same bits for any number
    int max_rounds = 100;  // rounds of the solver, each followed by T1s or relaxation
};

}  // namespace foam
