#pragma once

#include "core/equilibrium/soft_foam.h"
#include "core/foam/topology_thresholds.h"
#include "core/equilibrium/unknowns.h"

namespace foam {

/// Relaxation (E4): the way in from a foam that is far from equilibrium. Its films are arcs, each
/// with a half angle of its own; bubbles are soft.
struct RelaxationOptions {
    int sweeps = 60;
    double stiffness = 10.0;     // of a bubble against a change of its area, in film tensions
    double largest_move = 0.33;  // of a junction in a sweep, in its shortest films
    // Whether pressures and half angles are guessed from areas and lengths; else it goes on from
    // those it has.
    bool begins_anew = true;
    TopologyThresholds thresholds{};
};

struct RelaxationSummary {
    int sweeps = 0;
    int t1 = 0;
};

/// Sweeps over the junctions and the films, each moved by its own Newton step; T1 between sweeps.
/// Leaves each bubble with the pressure that its remaining area error stands for.
RelaxationSummary relax(Foam& foam, const RelaxationOptions& options);

/// The same for a part of the foam, all else held.
RelaxationSummary relax(Foam& foam, Unknowns part, const RelaxationOptions& options);

/// The same for one part after the other: in a large foam, memory for all of it is costly to clear.
/// The memory is one of the same foam.
RelaxationSummary relax(Foam& foam,
                        Unknowns part,
                        const RelaxationOptions& options,
                        SoftFoam& memory);

}  // namespace foam
