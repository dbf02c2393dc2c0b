#include "core/dynamics/step.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace foam {

namespace {

// A bubble up to this many T2 areas may lose all it has in one substep.
constexpr double kVanishingAreas = 4.0;

// The longest time in which no bubble loses too large a part of its area, but for those that
// vanish.
double safe_time(const Foam& foam, const StepOptions& options) {
    double time = std::numeric_limits<double>::infinity();
    const double vanishing = kVanishingAreas * options.equilibrium.thresholds.t2_area;
    for (const BubbleId bubble : foam.network.bubbles()) {
        const double rate = growth_rate(foam, bubble, options.coarsening);
        const double area = foam.target_areas[bubble];
        if (rate < 0.0 && area > vanishing) {
            time = std::min(time, options.largest_loss * area / -rate);
        }
    }
    return time;
}

// Takes away the rounding of many additions. In the plane, the total is what is left.
void restore_total(Foam& foam) {
    if (foam.torus.is_plane()) {
        return;
    }
    double total = 0.0;
    for (const BubbleId bubble : foam.network.bubbles()) {
        total += foam.target_areas[bubble];
    }
    for (const BubbleId bubble : foam.network.bubbles()) {
        foam.target_areas[bubble] *= foam.torus.area() / total;
    }
}

EquilibriumSummary substep(Foam& foam, double time, const StepOptions& options) {
    diffuse(foam, time, options.coarsening);
    const TopologyCounts counts = collapse_due(foam, options.equilibrium.thresholds);
    compact(foam);
    restore_total(foam);
    EquilibriumOptions equilibrium = options.equilibrium;
    equilibrium.relaxes_first = false;
    EquilibriumSummary summary = equilibrate(foam, equilibrium);
    summary.t1 += counts.t1;
    summary.t2 += counts.t2;
    foam.time += time;
    return summary;
}

void add(StepSummary& sum, const EquilibriumSummary& part) {
    EquilibriumSummary total = part;
    total.sweeps += sum.equilibrium.sweeps;
    total.iterations += sum.equilibrium.iterations;
    total.t1 += sum.equilibrium.t1;
    total.t2 += sum.equilibrium.t2;
    sum.equilibrium = total;
    ++sum.substeps;
}

// A substep of the given time or, where that leads to no equilibrium, of a shorter one; returns its
// time.
double advance(Foam& foam, double time, const StepOptions& options, StepSummary& summary) {
    for (int halvings = 0;; ++halvings, time *= 0.5) {
        Foam next = foam;
        const EquilibriumSummary part = substep(next, time, options);
        if (part.converged()) {
            foam = std::move(next);
            add(summary, part);
            return time;
        }
        if (halvings == options.max_halvings) {
            summary.equilibrium.status = part.status;
            return 0.0;
        }
    }
}

}  // namespace

StepSummary step(Foam& foam, double time, const StepOptions& options) {
    StepSummary summary;
    for (double left = time; left > 0.0;) {
        const double used =
            advance(foam, std::min(left, safe_time(foam, options)), options, summary);
        if (used == 0.0) {
            break;
        }
        left -= used;
    }
    return summary;
}

}  // namespace foam
