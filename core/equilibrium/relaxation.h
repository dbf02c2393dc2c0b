// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/equilibrium/soft_foam.h"
#include "core/equilibrium/unknowns.h"
#include "core/foam/topology_thresholds.h"

namespace foam {

/// Options of relaxation (E4), the method for a foam that is far from equilibrium. The half angle
/// of every film is an unknown of its own, and bubbles are soft: their pressure depends on their
/// area.
struct RelaxationOptions {
    int sweeps = 60;          // number of sweeps to make
    double stiffness = 10.0;  // resistance of a bubble to a change of its area, in film tensions
    // Largest move of a junction in one step, as a fraction of the chord length of each film at the
    // junction. The fraction limits how much the chord becomes shorter, and how far the end of the
    // chord moves sideways (for details, see allowed_fraction in moves.h).
    double largest_move = 0.33;
    // If true, the relaxation starts from pressures and half angles that are estimated from target
    // areas and chord lengths. If false, it starts from the present pressures and half angles of
    // the foam.
    bool restarts = true;
    TopologyThresholds thresholds{};
};

/// Counts the work of a relaxation.
struct RelaxationSummary {
    int sweeps = 0;  // number of sweeps
    int t1 = 0;      // number of T1s
};

/// Relaxes the whole foam. A sweep makes one Newton step for each junction in turn, and then one
/// for each half angle in turn. T1s are made between sweeps. At the end, each bubble has the
/// pressure that corresponds to its remaining area error.
RelaxationSummary relax(Foam& foam, const RelaxationOptions& options);

/// Relaxes a part of the foam: the unknowns `part` change, and everything else is held fixed.
RelaxationSummary relax(Foam& foam, Unknowns part, const RelaxationOptions& options);

/// Relaxes a part of the foam like the function above, but reuses `memory`, since clearing memory
/// for a large foam is costly. Precondition: `memory` was constructed for the same foam.
RelaxationSummary relax(Foam& foam,
                        Unknowns part,
                        const RelaxationOptions& options,
                        SoftFoam& memory);

}  // namespace foam
