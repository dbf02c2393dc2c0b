// SPDX-License-Identifier: Apache-2.0

#include "core/dynamics/step.h"

#include "core/dynamics/restore_rafts.h"
#include "core/dynamics/shear.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

// The time step is quasi-static (paper section 4.1): each substep changes target areas and topology
// and then finds the equilibrium anew. Three quantities limit the length of a substep:
// - the fraction of its area that a bubble loses by diffusion (E6),
// - the imposed change of areas,
// - the strain.
// The diffusion of a small bubble sets no limit; otherwise the last part of the life of each bubble
// would need substeps of its own. Until the network changes, growth rates are constant (von
// Neumann's law). A long substep therefore errs only in the moments at which the network changes. A
// substep works on a copy of the foam. If it finds no equilibrium, the copy is dropped and a
// substep of half the length is tried.

namespace foam {

namespace {

// A bubble whose target area is at most this fraction of the mean may lose all its area by
// diffusion in one substep.
constexpr double kVanishingFraction = 0.25;
// A driven bubble may lose all its target area in one substep if this area is at most this number
// times the T2 area. With a larger number, boiling loops (cycle.h) have twice as many T1s and take
// longer to close.
constexpr double kVanishingAreas = 4.0;
// The imposed change of areas never limits a substep to less than this fraction of the step. This
// bounds the number of substeps if the change is impossible, for example if every bubble of a
// torus is to shrink.
constexpr double kMinSubstepFraction = 0.01;
constexpr double kMaxStrain = 0.05;  // largest strain of one substep

// Returns the sum of the target areas of all bubbles, including lone bubbles.
double total_target_area(const Foam& foam) {
    double total = 0.0;
    for (const BubbleId bubble : foam.network.bubbles()) {
        total += foam.target_areas[bubble];
    }
    for (const LoneBubble& bubble : foam.lone_bubbles) {
        total += bubble.target_area;
    }
    return total;
}

// Returns the largest target area with which a bubble may lose all its area by diffusion in one
// substep.
double vanishing_area(const Foam& foam) {
    const std::size_t count = foam.network.bubble_count() + foam.lone_bubbles.size();
    return kVanishingFraction * total_target_area(foam) /
           static_cast<double>(std::max(count, std::size_t{1}));
}

// Returns the longest time that is safe for every bubble. In this time, no bubble above the
// vanishing area (vanishing_area) loses more than the fraction `largest_loss` of its area.
double safe_time(const Foam& foam, const StepOptions& options) {
    const double vanishing = vanishing_area(foam);
    double time = std::numeric_limits<double>::infinity();
    const auto limit_by = [&](double area, double growth_rate) {
        if (growth_rate < 0.0 && area > vanishing) {
            time = std::min(time, options.largest_loss * area / -growth_rate);
        }
    };
    for (const BubbleId bubble : foam.network.bubbles()) {
        limit_by(foam.target_areas[bubble], growth_rate(foam, bubble, options.coarsening));
    }
    for (const LoneBubble& bubble : foam.lone_bubbles) {
        limit_by(bubble.target_area, lone_growth_rate(foam, options.coarsening));
    }
    return time;
}

// Scales the target areas of a torus so that their sum is the area of the torus. This removes the
// rounding errors of many additions. Does nothing in the plane, where the sum is free.
void restore_total(Foam& foam) {
    if (foam.domain.is_plane()) {
        return;
    }
    const double total = total_target_area(foam);
    for (const BubbleId bubble : foam.network.bubbles()) {
        foam.target_areas[bubble] *= foam.domain.area() / total;
    }
}

// The time that a substep covers, and the part of a StateChange that it imposes.
struct SubstepExtent {
    double time = 0.0;
    double done = 0.0;              // fraction of the step's StateChange imposed before the substep
    double fraction = 1.0;          // fraction of the step's StateChange imposed in the substep
    double fraction_of_rest = 1.0;  // fraction / (1 - done)
};

// Applies the substep's fraction of every push. The center starts where the earlier substeps have
// moved it. Returns the number of T1s.
int push(Foam& foam,
         const StateChange& change,
         const SubstepExtent& extent,
         const TopologyThresholds& thresholds) {
    int flips = 0;
    for (Displacement displacement : change.pushes) {
        displacement.center += extent.done * displacement.by;
        displacement.by *= extent.fraction;
        flips += displace(foam, displacement, thresholds);
    }
    return flips;
}

// Makes one substep of the given extent. The counts of the summary include the T1s and T2s that
// were made before the equilibration.
EquilibriumSummary substep(Foam& foam,
                           const SubstepExtent& extent,
                           const StateChange& change,
                           const StepOptions& options) {
    diffuse(foam, extent.time, options.coarsening);
    drive(foam, change, extent.fraction_of_rest);
    if (change.strain != 0.0) {
        shear(foam, extent.fraction * change.strain);
    }
    TopologyCounts counts = collapse_due(foam, options.equilibrium.thresholds);
    counts.t1 += push(foam, change, extent, options.equilibrium.thresholds);
    if (extent.fraction_of_rest == 1.0) {
        const TopologyCounts forced = collapse_forced(foam, change);
        counts.t1 += forced.t1;
        counts.t2 += forced.t2;
    }
    compact(foam);
    restore_total(foam);
    EquilibriumOptions near_equilibrium = options.equilibrium;
    near_equilibrium.relaxes_first = false;
    EquilibriumSummary summary = equilibrate_keeping_rafts(options.solver, foam, near_equilibrium);
    summary.t1 += counts.t1;
    summary.t2 += counts.t2;
    foam.time += extent.time;
    return summary;
}

// Adds the counts of a substep to the sum. The sum takes its status, errors and energy from this
// substep.
void add(StepSummary& sum, const EquilibriumSummary& substep_summary) {
    EquilibriumSummary total = substep_summary;
    total.add_work(sum.equilibrium);
    total.t1 += sum.equilibrium.t1;
    total.t2 += sum.equilibrium.t2;
    sum.equilibrium = total;
    ++sum.substeps;
}

// Takes the events out of a foam, so that copies of the foam do not contain them. The destructor
// puts them back.
struct EventsSetAside {
    explicit EventsSetAside(Foam& the_foam)
        : foam(the_foam), events(std::exchange(the_foam.events, {})) {}
    EventsSetAside(const EventsSetAside&) = delete;
    EventsSetAside& operator=(const EventsSetAside&) = delete;
    ~EventsSetAside() { foam.events = std::move(events); }

    Foam& foam;
    std::vector<TopologyEvent> events;
};

// Makes a substep of the given length. While no equilibrium is found, halves the length and tries
// again, at most `max_halvings` times. Returns the length of the successful substep, or 0 if no
// substep succeeded. `make_substep` takes the foam and the length. The length may be a time or a
// fraction of the step; only `make_substep` interprets it.
template <class MakeSubstep>
double try_substep(Foam& foam,
                   double length,
                   const StepOptions& options,
                   StepSummary& summary,
                   const MakeSubstep& make_substep) {
    EventsSetAside earlier(foam);
    for (int halvings = 0;; ++halvings, length *= 0.5) {
        Foam next = foam;
        const EquilibriumSummary equilibrium = make_substep(next, length);
        if (equilibrium.converged()) {
            earlier.events.insert(earlier.events.end(), next.events.begin(), next.events.end());
            foam = std::move(next);
            add(summary, equilibrium);
            return length;
        }
        summary.equilibrium.relaxations += equilibrium.relaxations;
        if (halvings == options.max_halvings) {
            summary.equilibrium.status = equilibrium.status;
            return 0.0;
        }
    }
}

// Returns the largest fraction of a step that one substep may cover, at most `remaining`.
double safe_fraction(const Foam& foam,
                     double time,
                     const StateChange& change,
                     double remaining,
                     const StepOptions& options) {
    const double vanishing = kVanishingAreas * options.equilibrium.thresholds.t2_area;
    const double area_limit =
        remaining * max_fraction_of_change(foam, change, options.largest_loss, vanishing);
    const double strain_limit =
        change.strain == 0.0 ? remaining : kMaxStrain / std::abs(change.strain);
    const double fraction =
        std::min({remaining, strain_limit, std::max(area_limit, kMinSubstepFraction)});
    return time > 0.0 ? std::min(fraction, safe_time(foam, options) / time) : fraction;
}

}  // namespace

StepSummary step(Foam& foam, double time, const StepOptions& options) {
    StepSummary summary;
    for (double remaining = time; remaining > 0.0;) {
        const double used = try_substep(foam,
                                        std::min(remaining, safe_time(foam, options)),
                                        options,
                                        summary,
                                        [&](Foam& next, double length) {
                                            return substep(next, {.time = length}, {}, options);
                                        });
        if (used == 0.0) {
            break;
        }
        remaining -= used;
    }
    return summary;
}

StepSummary step(Foam& foam, double time, const StateChange& change, const StepOptions& options) {
    if (change.empty()) {
        return step(foam, time, options);
    }
    StepSummary summary;
    for (double remaining = 1.0; remaining > 0.0;) {
        const double used =
            try_substep(foam,
                        safe_fraction(foam, time, change, remaining, options),
                        options,
                        summary,
                        [&](Foam& next, double fraction) {
                            const SubstepExtent extent{
                                fraction * time, 1.0 - remaining, fraction, fraction / remaining};
                            return substep(next, extent, change, options);
                        });
        if (used == 0.0) {
            break;
        }
        summary.strain += used * change.strain;
        remaining -= used;
    }
    return summary;
}

}  // namespace foam
