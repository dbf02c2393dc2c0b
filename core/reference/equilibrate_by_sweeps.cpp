// SPDX-License-Identifier: Apache-2.0

#include "core/reference/equilibrate_by_sweeps.h"

#include "core/equilibrium/global_relaxation.h"
#include "core/equilibrium/untangle.h"
#include "core/foam/t1_rule.h"

#include <algorithm>

namespace foam {

// A round ends when the sweeps have converged or have reached their limit. If they have converged,
// the T1s of the short films follow; if no T1 is due, the foam is in equilibrium. If they have
// reached their limit, the equilibration ends with the status ToleranceMissed.

namespace {

RelaxationSummary relax_first(Foam& foam, const EquilibriumOptions& options) {
    SoftFoam memory(foam);
    return relax_globally(foam,
                          {.sweeps = std::max(1, options.relaxation_sweeps),
                           .further_sweeps = options.relaxation_sweeps,
                           .restarts = true,
                           .thresholds = options.thresholds,
                           .threads = options.threads},
                          memory);
}

}  // namespace

EquilibriumSummary equilibrate_by_sweeps(Foam& foam,
                                         SweepOrder order,
                                         const EquilibriumOptions& options) {
    const Positions before = foam.positions;
    if (foam.network.film_count() == 0) {  // empty, or only lone bubbles, which are circles already
        return conclude(foam, before, options, true, {});
    }
    EquilibriumSummary summary;
    if (untangle(foam) > 0 || options.relaxes_first) {
        const RelaxationSummary relaxation = relax_first(foam, options);
        summary.sweeps = relaxation.sweeps;
        summary.t1 = relaxation.t1;
    }
    const GaussSeidelOptions sweeping{.tolerance = options.tolerance,
                                      .order = order,
                                      .threads = options.threads,
                                      .thresholds = options.thresholds};
    bool is_at_rest = false;
    for (int round = 0; round < options.max_rounds && !is_at_rest; ++round) {
        const GaussSeidelSummary sweeps = gauss_seidel(foam, sweeping);
        summary.iterations += sweeps.sweeps;
        summary.t1 += sweeps.t1;
        is_at_rest = sweeps.status == GaussSeidelStatus::SweepLimit;
        if (!is_at_rest) {
            const int flips =
                apply_t1_rule(foam, short_films(foam, options.thresholds), options.thresholds);
            summary.t1 += flips;
            is_at_rest = flips == 0;
        }
    }
    return conclude(foam, before, options, is_at_rest, summary);
}

}  // namespace foam
