// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/dynamics/coarsening.h"
#include "core/dynamics/collapse.h"
#include "core/dynamics/solver.h"
#include "core/dynamics/state_change.h"

namespace foam {

/// Options for a step.
struct StepOptions {
    CoarseningOptions coarsening{};
    EquilibriumOptions equilibrium{};
    Solver solver = Solver::Newton;
    double largest_loss = 0.75;  // fraction of its area that a bubble may lose in a substep
    int max_halvings = 12;       // how often a substep that finds no equilibrium is halved
};

/// The result of a step: sums over its substeps, errors and energy at its end.
struct StepSummary {
    int substeps = 0;
    EquilibriumSummary equilibrium;
};

/// Advances a foam in equilibrium by the given time of coarsening: diffusion (E6), T2 (E8), T1 (E7)
/// and equilibrium, in as many substeps as the fastest bubble needs. The rafts of a patch stay
/// where they are (hold_rafts.h). If the summary is not converged, the foam is left in the last
/// equilibrium that was reached. Leaves no dead slots.
StepSummary step(Foam& foam, double time, const StepOptions& options);

/// Advances a foam as above while a change is imposed from outside, evenly over the time. The time
/// may be 0. More substeps are made if the change would take too much gas from a bubble, or give it
/// too much, at once.
StepSummary step(Foam& foam, double time, const StateChange& change, const StepOptions& options);

}  // namespace foam
