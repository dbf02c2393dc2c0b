#include "core/equilibrium/equilibrate.h"

#include "core/equilibrium/drift.h"
#include "core/equilibrium/global_relaxation.h"
#include "core/equilibrium/local_solve.h"
#include "core/equilibrium/newton.h"
#include "core/equilibrium/open_shut_bubbles.h"
#include "core/equilibrium/untangle.h"
#include "core/foam/measure.h"
#include "core/foam/t1_rule.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace foam {

namespace {

// A step of the whole foam that leaves more than this share of the residual is slow: it is held
// back by defect regions.
constexpr double kSlowRatio = 0.1;
// After this many rounds without equilibrium, regions are no longer solved on their own.
constexpr int kRoundsWithRegions = 20;
// Of the relaxations after a stall of Newton's method, one in this many is of the whole foam.
constexpr int kGlobalRelaxationPeriod = 4;

// The foam that all rounds work on, and their buffers.
struct Work {
    Work(Foam& the_foam, const EquilibriumOptions& the_options)
        : foam(the_foam), options(the_options), local(the_foam) {}

    Foam& foam;
    const EquilibriumOptions& options;
    NewtonSystem whole;  // of all unknowns
    LocalMemory local;
};

// The state that one round hands on to the next.
struct Progress {
    EquilibriumSummary summary;
    int rounds = 0;
    bool is_at_rest = false;      // Newton's method has converged, and no T1 is due
    bool solves_regions = true;   // defect regions on their own; false once they are given up
    bool stops_if_slow = false;   // Newton's method, for the sake of defect regions
    bool network_changed = true;  // since the whole system was started
    int global_relaxations = 0;
    int stalls_in_regions = 0;
};

void count_t1(int t1, Progress& progress) {
    progress.summary.t1 += t1;
    progress.network_changed = progress.network_changed || t1 > 0;
}

// Each relaxation has a quarter of the sweeps of the one before, down to one, and then all again:
// Newton's method is to start from another state than the one from which it stalled.
int next_sweeps(int sweeps, Progress& progress) {
    const int quarterings = progress.global_relaxations++ % 4;
    return std::max(1, sweeps >> (2 * quarterings));
}

void relax_all(Work& work, bool begins_anew, Progress& progress) {
    const GlobalRelaxationOptions options{
        .sweeps = next_sweeps(work.options.relaxation_sweeps, progress),
        .further_sweeps = work.options.relaxation_sweeps,
        .begins_anew = begins_anew,
        .thresholds = work.options.thresholds,
        .threads = work.options.threads};
    const RelaxationSummary relaxation = relax_globally(work.foam, options, work.local.soft);
    progress.summary.sweeps += relaxation.sweeps;
    count_t1(relaxation.t1, progress);
    progress.network_changed = true;  // pressures and half angles may have begun anew
}

// Returns the number of regions.
std::size_t solve_regions(Work& work, Progress& progress) {
    if (!progress.solves_regions) {
        return 0;
    }
    const LocalSummary local = solve_defect_regions(work.foam, work.options, work.local);
    count_t1(local.t1, progress);
    return local.regions;
}

// A large foam stalls because of a few bubbles: to relax these alone leaves the rest as it is.
// Where that does not help, all of it is relaxed.
void relax_where_stalled(Work& work, Progress& progress) {
    untangle(work.foam);  // a step of the whole foam may leave a tangle
    open_shut_bubbles(work.foam);
    std::vector<DefectRegion> regions = worst_regions(work.foam, work.options.threads);
    if (!progress.solves_regions || regions.empty() ||
        ++progress.stalls_in_regions % kGlobalRelaxationPeriod == 0) {
        relax_all(work, false, progress);
    } else {
        count_t1(relax_regions(work.foam, std::move(regions), work.options, work.local), progress);
    }
}

Progress first_phase(Work& work) {
    Progress progress;
    // Relaxation does not open them, but raises their pressures without end.
    open_shut_bubbles(work.foam);
    // A tangle is no state for Newton's method: its T1s would lead anywhere.
    if (untangle(work.foam) > 0 || work.options.relaxes_first) {
        relax_all(work, true, progress);
    }
    solve_regions(work, progress);
    return progress;
}

NewtonSummary solve_whole(Work& work, Progress& progress) {
    if (progress.network_changed) {
        work.whole.start(work.foam, all_unknowns(work.foam.network), work.options.threads);
        progress.network_changed = false;
    }
    const bool stops_if_slow = progress.solves_regions && progress.stops_if_slow;
    NewtonSummary summary = newton(work.foam,
                                   work.whole,
                                   {.slow_ratio = stops_if_slow ? kSlowRatio : 1.0,
                                    .predicts_t1 = progress.solves_regions,
                                    .thresholds = work.options.thresholds});
    progress.summary.iterations += summary.iterations;
    return summary;
}

// Does what Newton's method asks for where it has ended.
void respond(Work& work, const NewtonSummary& newton_summary, Progress& progress) {
    const auto apply_rule = [&](const std::vector<FilmId>& films) {
        const int t1 = apply_t1_rule(work.foam, films, work.options.thresholds);
        count_t1(t1, progress);
        return t1;
    };
    switch (newton_summary.status) {
        case NewtonStatus::Converged:
            if (films_at_limit(work.foam) > 0) {  // no equilibrium
                relax_all(work, false, progress);
            } else {
                progress.is_at_rest =
                    apply_rule(short_films(work.foam, work.options.thresholds)) == 0;
            }
            break;
        case NewtonStatus::FilmsCollapse:
            apply_rule(newton_summary.collapsing);
            break;
        case NewtonStatus::Slow:
            break;
        case NewtonStatus::Stalled:
        case NewtonStatus::IterationLimit:
            relax_where_stalled(work, progress);
            break;
    }
}

// Newton's method for the whole foam, what it asks for, and defect regions on their own.
Progress next_round(Work& work, Progress progress) {
    if (progress.rounds++ == kRoundsWithRegions) {
        progress.solves_regions = false;
        relax_all(work, false, progress);
    }
    if (work.foam.network.film_count() == 0) {  // all have torn
        progress.is_at_rest = true;
        return progress;
    }
    const NewtonSummary newton_summary = solve_whole(work, progress);
    respond(work, newton_summary, progress);
    if (!progress.is_at_rest) {
        const std::size_t regions = solve_regions(work, progress);
        // Slow without a region: it is slow everywhere, and goes on.
        progress.stops_if_slow = newton_summary.status != NewtonStatus::Slow || regions > 0;
    }
    return progress;
}

}  // namespace

EquilibriumSummary equilibrate(Foam& foam, const EquilibriumOptions& options) {
    const Positions before = foam.positions;
    if (foam.network.film_count() == 0) {  // lone bubbles, which are circles already, or nothing
        return conclude(foam, before, options, true, {});
    }
    Work work(foam, options);
    Progress progress = first_phase(work);
    while (!progress.is_at_rest && progress.rounds < options.max_rounds) {
        progress = next_round(work, progress);
    }
    return conclude(foam, before, options, progress.is_at_rest, progress.summary);
}

EquilibriumSummary conclude(Foam& foam,
                            const Positions& before,
                            const EquilibriumOptions& options,
                            bool is_at_rest,
                            EquilibriumSummary summary) {
    undo_drift(foam, before);
    center_pressures(foam);
    rearm_grown_films(foam, options.thresholds);
    const EquilibriumErrors errors = equilibrium_errors(foam);
    summary.area_error = errors.area;
    summary.angle_error = errors.angle;
    summary.energy = energy(foam);
    if (is_at_rest) {
        summary.status = errors.are_below(options.tolerance) ? EquilibriumStatus::Converged
                                                             : EquilibriumStatus::ToleranceMissed;
    }
    return summary;
}

}  // namespace foam
