#pragma once

#include "core/dynamics/coarsening.h"
#include "core/dynamics/collapse.h"
#include "core/dynamics/state_change.h"
#include "core/equilibrium/equilibrate.h"

namespace foam {

struct StepOptions {
    CoarseningOptions coarsening{};
    EquilibriumOptions equilibrium{};
    double largest_loss = 0.75;  // of its area, of a bubble in a substep; then the step is cut
    int max_halvings = 12;       // of a substep that leads to no equilibrium
};

/// What a step did: sums over its substeps, errors and energy at its end.
struct StepSummary {
    int substeps = 0;
    EquilibriumSummary equilibrium;
};

/// Takes a foam in equilibrium, a patch without moving it as a whole (hold_rafts.h), through a time
/// of coarsening: diffusion (E6), T2 (E8), T1 (E7) and equilibrium, in as many substeps as the
/// fastest bubble asks for. Where the summary is not converged, the foam is left in the last
/// equilibrium before the time was used up. Leaves no dead slots.
StepSummary step(Foam& foam, double time, const StepOptions& options);

/// A step in which a change is imposed from outside as well, evenly over its time, which may be
/// none. It is also cut where the change would take or give a bubble too much at once.
StepSummary step(Foam& foam, double time, const StateChange& change, const StepOptions& options);

}  // namespace foam
