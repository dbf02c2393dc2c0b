#pragma once

#include "core/equilibrium/soft_foam.h"
#include "core/equilibrium/unknowns.h"
#include "core/foam/topology_thresholds.h"

namespace foam {

/// Relaxation (E4): the initial phase for a foam that is far from equilibrium. Films are arcs, each
/// with a half angle of its own; bubbles are soft.
struct RelaxationOptions {
    int sweeps = 60;
    double stiffness = 10.0;     // of a bubble against a change of its area, in film tensions
    double largest_move = 0.33;  // of a junction in a sweep, in its shortest films
    // Starts from pressures and half angles that are guessed from areas and lengths, instead of
    // those that the foam has.
    bool begins_anew = true;
    TopologyThresholds thresholds{};
};

struct RelaxationSummary {
    int sweeps = 0;
    int t1 = 0;
};

/// Sweeps over the junctions and the films, each moved by its own Newton step, with T1s between
/// sweeps. Leaves each bubble with the pressure that follows from its remaining area error.
RelaxationSummary relax(Foam& foam, const RelaxationOptions& options);

/// The same for a part of the foam; everything else is held.
RelaxationSummary relax(Foam& foam, Unknowns part, const RelaxationOptions& options);

/// The same with memory that serves one part after another: memory for all of a large foam is
/// costly to clear. `memory` belongs to the same foam.
RelaxationSummary relax(Foam& foam,
                        Unknowns part,
                        const RelaxationOptions& options,
                        SoftFoam& memory);

}  // namespace foam
