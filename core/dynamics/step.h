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
    EquilibriumOptions equilibrium{};  // relaxes_first has no effect: a step starts in equilibrium
    Solver solver = Solver::Newton;
    double largest_loss = 0.75;  // largest fraction of its area that a bubble loses in a substep
    int max_halvings = 12;       // largest number of times that a failed substep is halved
};

/// The result of a step. The counts and the strain are sums over all substeps that found an
/// equilibrium; only the number of relaxations includes failed substeps, too. The errors and the
/// energy describe the foam at the end of the step; they are 0 if no substep found an equilibrium.
struct StepSummary {
    int substeps = 0;
    EquilibriumSummary equilibrium;
    double strain = 0.0;  // the strain by which the foam was sheared (StateChange::strain)
};

/// Advances a foam in equilibrium by the given time: diffusion (E6), T2 (E8), T1 (E7) and
/// equilibrium. The step is divided into substeps. In one substep, diffusion may take from a bubble
/// at most the fraction `largest_loss` of its area. Only a bubble whose target area is at most a
/// quarter of the mean target area may lose all of its area. The rafts of a patch stay where they
/// are (restore_rafts.h). A substep that finds no equilibrium is halved and tried again. If it
/// still fails after `max_halvings` halvings, the step ends. The summary is then not converged, and
/// the foam is left in the last equilibrium that was reached. If EquilibriumOptions::on_round
/// throws an exception, the foam is left in this equilibrium, too, and the exception is passed on.
/// If the time is 0, no substep is made and the summary is not converged. Every substep removes all
/// dead slots (compact).
StepSummary step(Foam& foam, double time, const StepOptions& options);

/// Advances the foam in the same way while a change from outside (E9) is imposed evenly over the
/// time. If the time is 0, the change is imposed without diffusion; if the change is empty, too, no
/// substep is made. More substeps are made if the change of an area, or the strain, would be too
/// large for one substep.
StepSummary step(Foam& foam, double time, const StateChange& change, const StepOptions& options);

}  // namespace foam
