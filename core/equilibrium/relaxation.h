// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/equilibrium/soft_foam.h"
#include "core/equilibrium/unknowns.h"
#include "core/foam/topology_thresholds.h"

namespace foam {

/// Options of relaxation (E4), the initial phase for a foam that is far from equilibrium. Films are
/// arcs with half angles of their own, and bubbles are soft: their pressure depends on their area.
struct RelaxationOptions {
    int sweeps = 60;
    double stiffness = 10.0;  // resistance of a bubble to a change of its area, in film tensions
    // Largest relative motion of the two ends of a film in one move of a junction, in film lengths
    // (allowed_fraction).
    double largest_move = 0.33;
    // Starts from pressures and half angles that are estimated from target areas and film lengths,
    // instead of those of the foam.
    bool restarts = true;
    TopologyThresholds thresholds{};
};

/// The work of a relaxation.
struct RelaxationSummary {
    int sweeps = 0;
    int t1 = 0;
};

/// Relaxes the whole foam. A sweep moves one junction, and then one half angle, after another by a
/// Newton step of its own. T1s are made between sweeps. Afterwards each bubble has the pressure
/// that corresponds to its remaining area error.
RelaxationSummary relax(Foam& foam, const RelaxationOptions& options);

/// Relaxes a part of the foam; everything else is held.
RelaxationSummary relax(Foam& foam, Unknowns part, const RelaxationOptions& options);

/// Relaxes a part of the foam like the function above, but reuses `memory`, since clearing memory
/// for a large foam is costly. Precondition: `memory` belongs to the same foam.
RelaxationSummary relax(Foam& foam,
                        Unknowns part,
                        const RelaxationOptions& options,
                        SoftFoam& memory);

}  // namespace foam
