// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/topology_thresholds.h"

#include <functional>
#include <memory>

namespace foam {

class NewtonSystem;

/// Options of `equilibrate` and of `equilibrate_by_sweeps` (core/reference).
struct EquilibriumOptions {
    TopologyThresholds thresholds{};
    // The equilibrium is accepted if the errors of the foam are below this number
    // (EquilibriumErrors::are_below). The Gauss-Seidel solver (E5) also stops its sweeps at this
    // tolerance; it is very slow if the tolerance is below 1e-4.
    double tolerance = 1e-9;
    bool relaxes_first = true;  // relaxes the foam first (E4), for a foam far from equilibrium
    // Number of sweeps of each relaxation of a region around a large error (worst_regions in
    // local_solve.h). It is also the number of sweeps of each pass of a relaxation of the whole
    // foam (GlobalRelaxationOptions). Exception: `equilibrate` varies the number in the first pass
    // of each relaxation of the whole foam (next_sweeps in equilibrate.cpp). If this number is 60,
    // the first passes have 60, 15, 3, 1, 60, ... sweeps.
    int relaxation_sweeps = 60;
    // Number of threads; 0 for all threads of the hardware (thread_count). The result has the same
    // bits for any number of threads.
    int threads = 0;
    // Largest number of rounds. A round is a run of the solver and the response to its result: T1s,
    // relaxation, or solving the defect regions.
    int max_rounds = 100;
    // The linear system that `equilibrate` uses and leaves for the next call, which may then reuse
    // its analysis and its factor (NewtonSystem::start_whole); null for a new system. The result
    // depends on earlier calls with the same system: on their number, states and networks. The
    // system must not be used by two calls at the same time.
    std::shared_ptr<NewtonSystem> system = {};
    // Called before each round, if it is not empty. May throw an exception to end the solver, which
    // passes it on; the foam is then in a state between two rounds.
    std::function<void()> on_round = {};
};

}  // namespace foam
