#pragma once

#include "core/foam/topology_thresholds.h"

namespace foam {

struct EquilibriumOptions {
    TopologyThresholds thresholds{};
    // Succeeds if the largest area and angle errors are below this. Gauss-Seidel also stops there;
    // below 1e-4 it takes long.
    double tolerance = 1e-9;
    bool relaxes_first = true;   // for a foam that is far from equilibrium (E4)
    int relaxation_sweeps = 60;  // at first, and where Newton's method stalls
    int threads = 0;             // as in parallel_for; the result has the same bits for any number
    int max_rounds = 100;        // of the solver, each followed by T1s or relaxation
};

}  // namespace foam
