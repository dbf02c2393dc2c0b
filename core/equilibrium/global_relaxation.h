// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/equilibrium/relaxation.h"

namespace foam {

/// Options for the relaxation of the whole foam (E4).
struct GlobalRelaxationOptions {
    int sweeps = 60;
    // Sweeps of each further pass.
    int further_sweeps = 60;
    // The first pass resets pressures and half angles (RelaxationOptions::restarts). Even if this
    // is false, it does so if the foam is tangled, has films at the limit of their half angle, or
    // is a patch that is far from equilibrium in a large part.
    bool restarts = false;
    TopologyThresholds thresholds{};
    int threads = 0;  // same meaning as in parallel_for
};

/// Untangles the foam and relaxes it until Newton's method can take over. Further passes follow
/// while a patch is far from equilibrium in a large part. They also follow while films are at the
/// limit of their half angle, if the first pass has left many films there. The number of passes is
/// bounded. Returns sums over all passes. Precondition: `memory` belongs to the same foam.
RelaxationSummary relax_globally(Foam& foam,
                                 const GlobalRelaxationOptions& options,
                                 SoftFoam& memory);

}  // namespace foam
