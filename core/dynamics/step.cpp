// SPDX-License-Identifier: Apache-2.0

#include "core/dynamics/step.h"

#include "core/dynamics/hold_rafts.h"
#include "core/dynamics/shear.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>
#include <vector>

// The time step is quasi-static (paper section 4.1): each substep changes target areas and topology
// and then finds the equilibrium anew. Three limits bound the length of a substep: the fraction of
// its area that a bubble may lose by diffusion (E6), the imposed change of areas, and the strain. A
// substep works on a copy of the foam. If it finds no equilibrium, the copy is dropped and a
// substep of half the length is tried.

namespace foam {

namespace {

// A bubble of up to this many T2 areas may lose all its area in one substep.
constexpr double kVanishingAreas = 4.0;
// Smallest fraction of a driven step to which the change of areas limits a substep. It bounds the
// number of substeps if the change is impossible, for example if every bubble is to shrink.
constexpr double kMinSubstepFraction = 0.01;
constexpr double kLargestStrain = 0.05;  // largest strain of one substep

// Returns the longest time in which a bubble loses at most the fraction `largest_loss` of its area;
// infinity if it grows or is about to vanish.
double safe_time(double area, double rate, const StepOptions& options) {
    const double vanishing = kVanishingAreas * options.equilibrium.thresholds.t2_area;
    return rate < 0.0 && area > vanishing ? options.largest_loss * area / -rate
                                          : std::numeric_limits<double>::infinity();
}

// Returns the longest time that is safe for every bubble.
double safe_time(const Foam& foam, const StepOptions& options) {
    double time = std::numeric_limits<double>::infinity();
    for (const BubbleId bubble : foam.network.bubbles()) {
        const double rate = growth_rate(foam, bubble, options.coarsening);
        time = std::min(time, safe_time(foam.target_areas[bubble], rate, options));
    }
    for (const LoneBubble& bubble : foam.lone_bubbles) {
        const double rate = lone_growth_rate(foam, options.coarsening);
        time = std::min(time, safe_time(bubble.target_area, rate, options));
    }
    return time;
}

// Scales the target areas of a torus to its area, to remove the rounding errors of many additions.
// In the plane there is no total to restore.
void restore_total(Foam& foam) {
    if (foam.domain.is_plane()) {
        return;
    }
    double total = 0.0;
    for (const BubbleId bubble : foam.network.bubbles()) {
        total += foam.target_areas[bubble];
    }
    for (const BubbleId bubble : foam.network.bubbles()) {
        foam.target_areas[bubble] *= foam.domain.area() / total;
    }
}

// Moves every push by a fraction of its displacement. Returns the number of T1s.
int push(Foam& foam,
         const StateChange& change,
         double fraction,
         const TopologyThresholds& thresholds) {
    int flips = 0;
    for (Displacement part : change.pushes) {
        part.by *= fraction;
        flips += displace(foam, part, thresholds);
    }
    return flips;
}

// Brings a foam that is near equilibrium to equilibrium. The rafts of a patch stay where they are.
EquilibriumSummary equilibrate_in_place(Foam& foam, const StepOptions& step_options) {
    EquilibriumOptions options = step_options.equilibrium;
    options.relaxes_first = false;
    if (foam.network.ghost() == kNone<BubbleId>) {
        return equilibrate_with(step_options.solver, foam, options);
    }
    const std::map<BubbleIdentity, Vec2> before = bubble_centers(foam);
    const EquilibriumSummary summary = equilibrate_with(step_options.solver, foam, options);
    compact(foam);  // films may have torn
    if (summary.converged()) {
        hold_rafts(foam, before);
    }
    return summary;
}

// The extent of a substep.
struct Extent {
    double time = 0.0;
    double fraction = 1.0;  // fraction of the whole change
    double part = 1.0;      // fraction of the remaining change
};

EquilibriumSummary substep(Foam& foam,
                           const Extent& extent,
                           const StateChange& change,
                           const StepOptions& options) {
    diffuse(foam, extent.time, options.coarsening);
    drive(foam, change, extent.part);
    if (change.strain != 0.0) {
        shear(foam, extent.fraction * change.strain);
    }
    TopologyCounts counts = collapse_due(foam, options.equilibrium.thresholds);
    counts.t1 += push(foam, change, extent.fraction, options.equilibrium.thresholds);
    if (extent.part == 1.0) {
        const TopologyCounts forced = collapse_forced(foam, change);
        counts.t1 += forced.t1;
        counts.t2 += forced.t2;
    }
    compact(foam);
    restore_total(foam);
    EquilibriumSummary summary = equilibrate_in_place(foam, options);
    summary.t1 += counts.t1;
    summary.t2 += counts.t2;
    foam.time += extent.time;
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

// Makes a substep of the given length or, if no equilibrium is found, a shorter substep. Returns
// the length of the substep, or 0 if none succeeded. `substep_of` takes the foam and the length.
template <class Substep>
double advance(Foam& foam,
               double length,
               const StepOptions& options,
               StepSummary& summary,
               const Substep& substep_of) {
    std::vector<TopologyEvent> events = std::exchange(foam.events, {});  // to avoid copying them
    for (int halvings = 0;; ++halvings, length *= 0.5) {
        Foam next = foam;
        const EquilibriumSummary part = substep_of(next, length);
        if (part.converged()) {
            events.insert(events.end(), next.events.begin(), next.events.end());
            foam = std::move(next);
            foam.events = std::move(events);
            add(summary, part);
            return length;
        }
        if (halvings == options.max_halvings) {
            foam.events = std::move(events);
            summary.equilibrium.status = part.status;
            return 0.0;
        }
    }
}

// Returns the largest fraction of a step that one substep may cover, at most `left`.
double safe_fraction(const Foam& foam,
                     double time,
                     const StateChange& change,
                     double left,
                     const StepOptions& options) {
    const double vanishing = kVanishingAreas * options.equilibrium.thresholds.t2_area;
    const double part = safe_part(foam, change, options.largest_loss, vanishing);
    const double strained = change.strain == 0.0 ? left : kLargestStrain / std::abs(change.strain);
    const double fraction = std::min({left, strained, std::max(part * left, kMinSubstepFraction)});
    return time > 0.0 ? std::min(fraction, safe_time(foam, options) / time) : fraction;
}

}  // namespace

StepSummary step(Foam& foam, double time, const StepOptions& options) {
    StepSummary summary;
    for (double left = time; left > 0.0;) {
        const double used = advance(foam,
                                    std::min(left, safe_time(foam, options)),
                                    options,
                                    summary,
                                    [&](Foam& next, double length) {
                                        return substep(next, {.time = length}, {}, options);
                                    });
        if (used == 0.0) {
            break;
        }
        left -= used;
    }
    return summary;
}

StepSummary step(Foam& foam, double time, const StateChange& change, const StepOptions& options) {
    if (change.empty()) {
        return step(foam, time, options);
    }
    StepSummary summary;
    for (double left = 1.0; left > 0.0;) {
        const double used =
            advance(foam,
                    safe_fraction(foam, time, change, left, options),
                    options,
                    summary,
                    [&](Foam& next, double fraction) {
                        const Extent extent{fraction * time, fraction, fraction / left};
                        return substep(next, extent, change, options);
                    });
        if (used == 0.0) {
            break;
        }
        left -= used;
    }
    return summary;
}

}  // namespace foam
