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
    int max_halvings = 12;       // largest number of times that a failed substep is halved
};

/// The result of a step. Its counts are sums over all substeps. Its errors and its energy are those
/// at the end of the step.
struct StepSummary {
    int substeps = 0;
    EquilibriumSummary equilibrium;
};

/// Advances a foam in equilibrium by the given time of coarsening: diffusion (E6), T2 (E8), T1 (E7)
/// and equilibrium. A substep ends before a bubble has lost too much of its area. The rafts of a
/// patch stay where they are (hold_rafts.h). If a substep finds no equilibrium, the summary is not
/// converged, and the foam is left in the last equilibrium that was reached. Leaves no dead slots.
StepSummary step(Foam& foam, double time, const StepOptions& options);

/// Does the same while a change from outside (E9) is imposed evenly over the time. The time may be
/// 0. More substeps are made if the change of an area, or the strain, would be too large for one.
StepSummary step(Foam& foam, double time, const StateChange& change, const StepOptions& options);

}  // namespace foam
