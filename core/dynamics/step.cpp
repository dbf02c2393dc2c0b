#include "core/dynamics/step.h"

#include "core/dynamics/hold_rafts.h"
#include "core/dynamics/shear.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace foam {

namespace {

// A bubble up to this many T2 areas may lose all it has in one substep.
constexpr double kVanishingAreas = 4.0;
// Of a step with a change, a substep is at least this share, as far as the change is concerned: one
// that cannot be had, as when all bubbles are to shrink, comes to an end all the same.
constexpr double kLeastShare = 0.01;
constexpr double kLargestStrain = 0.05;  // of a substep

// The longest time in which a bubble does not lose too large a part of its area, unless it
// vanishes.
double safe_time(double area, double rate, const StepOptions& options) {
    const double vanishing = kVanishingAreas * options.equilibrium.thresholds.t2_area;
    return rate < 0.0 && area > vanishing ? options.largest_loss * area / -rate
                                          : std::numeric_limits<double>::infinity();
}

// The same for all bubbles.
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

// Takes away the rounding of many additions. In the plane, the total is what is left.
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

// The share of the way of every push; returns the number of T1.
int push(Foam& foam,
         const StateChange& change,
         double share,
         const TopologyThresholds& thresholds) {
    int flips = 0;
    for (Displacement part : change.pushes) {
        part.by *= share;
        flips += displace(foam, part, thresholds);
    }
    return flips;
}

// From near an equilibrium to it. A patch stays in its place.
EquilibriumSummary settle(Foam& foam, EquilibriumOptions options) {
    options.relaxes_first = false;
    if (foam.network.ghost() == kNone<BubbleId>) {
        return equilibrate(foam, options);
    }
    const std::map<BubbleIdentity, Vec2> before = bubble_centres(foam);
    const EquilibriumSummary summary = equilibrate(foam, options);
    compact(foam);  // films may have torn
    if (summary.converged()) {
        hold_rafts(foam, before);
    }
    return summary;
}

// What a substep takes: its time, its share of a whole change, and its part of what is left of it.
struct Passing {
    double time = 0.0;
    double share = 1.0;
    double part = 1.0;
};

EquilibriumSummary substep(Foam& foam,
                           const Passing& passing,
                           const StateChange& change,
                           const StepOptions& options) {
    diffuse(foam, passing.time, options.coarsening);
    drive(foam, change, passing.part);
    if (change.strain != 0.0) {
        shear(foam, passing.share * change.strain);
    }
    TopologyCounts counts = collapse_due(foam, options.equilibrium.thresholds);
    counts.t1 += push(foam, change, passing.share, options.equilibrium.thresholds);
    if (passing.part == 1.0) {
        const TopologyCounts forced = collapse_forced(foam, change);
        counts.t1 += forced.t1;
        counts.t2 += forced.t2;
    }
    compact(foam);
    restore_total(foam);
    EquilibriumSummary summary = settle(foam, options.equilibrium);
    summary.t1 += counts.t1;
    summary.t2 += counts.t2;
    foam.time += passing.time;
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

// A substep of the given length or, where that leads to no equilibrium, of a shorter one; returns
// its length. `substep_of` takes the foam and the length.
template <class Substep>
double advance(Foam& foam,
               double length,
               const StepOptions& options,
               StepSummary& summary,
               const Substep& substep_of) {
    std::vector<TopologyEvent> events = std::exchange(foam.events, {});  // not to copy them
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

// The largest share of a step that may pass at once, of which `left` is left.
double safe_share(const Foam& foam,
                  double time,
                  const StateChange& change,
                  double left,
                  const StepOptions& options) {
    const double vanishing = kVanishingAreas * options.equilibrium.thresholds.t2_area;
    const double part = safe_part(foam, change, options.largest_loss, vanishing);
    const double strained = change.strain == 0.0 ? left : kLargestStrain / std::abs(change.strain);
    const double share = std::min({left, strained, std::max(part * left, kLeastShare)});
    return time > 0.0 ? std::min(share, safe_time(foam, options) / time) : share;
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
        const double used = advance(foam,
                                    safe_share(foam, time, change, left, options),
                                    options,
                                    summary,
                                    [&](Foam& next, double share) {
                                        const Passing passing{share * time, share, share / left};
                                        return substep(next, passing, change, options);
                                    });
        if (used == 0.0) {
            break;
        }
        left -= used;
    }
    return summary;
}

}  // namespace foam
