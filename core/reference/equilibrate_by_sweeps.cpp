// SPDX-License-Identifier: Apache-2.0

#include "core/reference/equilibrate_by_sweeps.h"

#include "core/equilibrium/global_relaxation.h"
#include "core/equilibrium/untangle.h"
#include "core/foam/t1_rule.h"

#include <algorithm>

namespace foam {

// The algorithm repeats rounds, at most EquilibriumOptions::max_rounds of them. The sweeps of a
// round end when the errors are below the tolerance or the number of sweeps has reached the limit
// (GaussSeidelOptions::max_sweeps). If the errors are below the tolerance, the T1s of the short
// films follow; if no T1 is due, the foam is in equilibrium. If the limit has been reached, the
// equilibration ends with the status ToleranceMissed.

namespace {

RelaxationSummary relax_first(Foam& foam, const EquilibriumOptions& options) {
    SoftFoam soft(foam);
    return relax_globally(foam,
                          {.sweeps = std::max(1, options.relaxation_sweeps),
                           .further_sweeps = options.relaxation_sweeps,
                           .restarts = true,
                           .thresholds = options.thresholds,
                           .threads = options.threads},
                          soft);
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
        summary.relaxations = 1;
        summary.sweeps = relaxation.sweeps;
        summary.t1 = relaxation.t1;
    }
    const GaussSeidelOptions sweeping{.tolerance = options.tolerance,
                                      .order = order,
                                      .threads = options.threads,
                                      .thresholds = options.thresholds};
    bool has_stopped = false;
    for (int round = 0; round < options.max_rounds && !has_stopped; ++round) {
        if (options.on_round) {
            options.on_round();
        }
        const GaussSeidelSummary sweeps = gauss_seidel(foam, sweeping);
        summary.iterations += sweeps.sweeps;
        summary.t1 += sweeps.t1;
        has_stopped = sweeps.status == GaussSeidelStatus::SweepLimit;
        if (!has_stopped) {
            const int flips =
                apply_t1_rule(foam, short_films(foam, options.thresholds), options.thresholds);
            summary.t1 += flips;
            has_stopped = flips == 0;
        }
    }
    return conclude(foam, before, options, has_stopped, summary);
}

}  // namespace foam
