#pragma once

#include "core/equilibrium/relaxation.h"

namespace foam {

/// Relaxation of the whole foam (E4) until Newton's method can take over.
struct GlobalRelaxationOptions {
    int sweeps = 60;
    int further_sweeps = 60;   // of each further pass, while the foam is far from equilibrium
    bool begins_anew = false;  // see RelaxationOptions; a foam that is far always does
    TopologyThresholds thresholds{};
    int threads = 0;  // as in parallel_for
};

/// Untangles the foam and relaxes it, again and again while it is far from equilibrium all over, a
/// bounded number of times. `memory` belongs to the same foam. Returns sums over all passes.
RelaxationSummary relax_globally(Foam& foam,
                                 const GlobalRelaxationOptions& options,
                                 SoftFoam& memory);

}  // namespace foam
