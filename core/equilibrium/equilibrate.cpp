// SPDX-License-Identifier: Apache-2.0

#include "core/equilibrium/equilibrate.h"

#include "core/equilibrium/drift.h"
#include "core/equilibrium/global_relaxation.h"
#include "core/equilibrium/local_solve.h"
#include "core/equilibrium/newton.h"
#include "core/equilibrium/reopen_collapsed_bubbles.h"
#include "core/equilibrium/untangle.h"
#include "core/foam/measure.h"
#include "core/foam/t1_rule.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

namespace foam {

// The equilibration is made in rounds. A round begins with Newton's method (E3) for the whole foam.
// The response to the result of the method follows: T1s if films need them, or relaxation (E4) of
// the worst regions or of the whole foam if the method has stalled. At the end of the round, the
// defect regions are solved on their own, while everything else stays fixed. README.md shows the
// algorithm and its reasons, NOTES.md the measurements.

namespace {

// Defects around which regions are solved before the first step of the whole foam. Only large
// errors count, because after a time step every bubble has an error.
constexpr DefectOptions kFirstDefects{.force = 0.05, .area = 0.15};
// Defects around which regions are solved at the end of every round. After a step of the whole
// foam, errors are small except near T1s. Lower thresholds save no more time (NOTES.md).
constexpr DefectOptions kLaterDefects{.force = 0.02, .area = 0.05};
// A step of the whole foam with a new factor is slow if it leaves more than this share of the norm
// of the residual. Defect regions are then assumed to limit the progress.
constexpr double kSlowRatio = 0.1;
// The smallest tolerance of Newton's method (newton_tolerance).
constexpr double kNewtonTolerance = 1e-11;
// The tolerance is this number times the size of the foam (see newton_tolerance) if the product is
// more than kNewtonTolerance, as on square tori of more than about 10,000 bubbles.
constexpr double kNewtonTolerancePerSize = 1e-13;
// The tolerance grows with the foam to at most this number times the tolerance of the equilibrium.
constexpr double kMaxToleranceRatio = 0.1;
// After this many rounds, the whole foam is relaxed, and no defect regions are solved any more.
constexpr int kRoundsWithRegions = 20;
// At every kGlobalRelaxationPeriod-th stall of Newton's method, the whole foam is relaxed instead
// of the worst regions (relax_where_stalled).
constexpr int kGlobalRelaxationPeriod = 4;

// The foam that all rounds work on, and the buffers that they reuse. Unless an equilibrium has been
// found, the destructor drops the factor, because it belongs to a state that the caller may drop.
struct Work {
    Work(Foam& the_foam, const EquilibriumOptions& the_options)
        : foam(the_foam),
          options(the_options),
          system(the_options.system ? the_options.system : std::make_shared<NewtonSystem>()),
          whole(*system),
          local(the_foam) {}
    Work(const Work&) = delete;
    Work& operator=(const Work&) = delete;
    ~Work() {
        if (!has_converged) {
            whole.drop_factor();
        }
    }

    Foam& foam;
    const EquilibriumOptions& options;
    bool has_converged = false;
    std::shared_ptr<NewtonSystem> system;
    NewtonSystem& whole;  // *system: the system of all unknowns of the foam
    RegionBuffers local;  // for the defect regions and for all relaxations
};

// The state that is passed from one round to the next.
struct Progress {
    EquilibriumSummary summary;
    int rounds = 0;
    bool is_at_rest = false;  // Newton's method has converged and no T1 is due, or no film is left
    // True while defect regions are solved on their own, in the first kRoundsWithRegions rounds.
    // While it is true, Newton's method also predicts T1s (NewtonOptions::predicts_t1): near
    // equilibrium it ends early if a short film would still be short after the next step.
    bool solves_regions = true;
    // True if Newton's method stops after a slow step, so that defect regions can be solved. It has
    // no effect if `solves_regions` is false.
    bool stops_if_slow = false;
    bool needs_restart = true;  // Work::whole must be started before it is used
    int counted_stalls = 0;     // stalls after which regions could be relaxed
};

void count_t1(int t1, Progress& progress) {
    progress.summary.t1 += t1;
    progress.needs_restart = progress.needs_restart || t1 > 0;
}

// Returns the number of sweeps of the first pass of the next relaxation of the whole foam, and
// counts this relaxation in `progress`. The number is in turn `sweeps`, a quarter, a sixteenth and
// a sixty-fourth of it, but at least one. It varies because Newton's method might otherwise stall
// in the same state again.
int next_sweeps(int sweeps, Progress& progress) {
    const int quarterings = progress.summary.relaxations++ % 4;
    return std::max(1, sweeps >> (2 * quarterings));
}

void relax_all(Work& work, bool restarts, Progress& progress) {
    const GlobalRelaxationOptions options{
        .sweeps = next_sweeps(work.options.relaxation_sweeps, progress),
        .further_sweeps = work.options.relaxation_sweeps,
        .restarts = restarts,
        .thresholds = work.options.thresholds,
        .threads = work.options.threads};
    const RelaxationSummary relaxation = relax_globally(work.foam, options, work.local.soft);
    progress.summary.sweeps += relaxation.sweeps;
    count_t1(relaxation.t1, progress);
    progress.needs_restart = true;
    work.whole.drop_factor();  // the factor belongs to the state before the relaxation
}

// Solves the regions around defects on their own and returns their number. Does nothing and returns
// 0 if regions are no longer solved on their own.
std::size_t solve_regions(Work& work, const DefectOptions& defects, Progress& progress) {
    if (!progress.solves_regions) {
        return 0;
    }
    const LocalSummary local = solve_defect_regions(work.foam, defects, work.options, work.local);
    count_t1(local.t1, progress);
    return local.regions;
}

// Responds to a stall of Newton's method or to its limit of iterations. Relaxes the worst regions,
// since usually a few bubbles are the cause. The whole foam is relaxed instead every
// kGlobalRelaxationPeriod-th time, or if there are no such regions or they are no longer solved.
void relax_where_stalled(Work& work, Progress& progress) {
    untangle(work.foam);  // a Newton step may have tangled some junctions
    reopen_collapsed_bubbles(work.foam);
    // On the way from a raw diagram, small regions are less reliable than the whole foam
    // (NOTES.md).
    const int fewest_rings = work.options.relaxes_first ? kWorstRings : 1;
    std::vector<DefectRegion> regions =
        worst_regions(work.foam, work.options.threads, fewest_rings);
    if (!progress.solves_regions || regions.empty() ||
        ++progress.counted_stalls % kGlobalRelaxationPeriod == 0) {
        relax_all(work, false, progress);
    } else {
        count_t1(relax_regions(work.foam, std::move(regions), work.options, work.local), progress);
    }
}

Progress initial_phase(Work& work) {
    Progress progress;
    // In a small foam, a few defects are not the likely cause of a slow first step.
    progress.stops_if_slow = work.foam.network.film_count() >= kLargeFoam;
    // Relaxation would raise the pressures of collapsed bubbles without bound.
    reopen_collapsed_bubbles(work.foam);
    // In a tangled foam, Newton's method would request arbitrary T1s.
    if (untangle(work.foam) > 0 || work.options.relaxes_first) {
        relax_all(work, true, progress);
    } else {
        solve_regions(work, kFirstDefects, progress);
    }
    return progress;
}

// Returns the tolerance of Newton's method for forces, in film tensions, and for relative area
// errors. `tolerance` is that of the equilibrium. Rounding errors are in proportion to the size of
// the foam: the largest coordinate in square roots of the mean area of a bubble. This size is 316
// for a torus of 100,000 bubbles, whose errors do not fall below 2e-11. With a smaller tolerance,
// the method would stall, and the precision of the factor would be raised.
double newton_tolerance(const Foam& foam, double tolerance) {
    double largest = 0.0;
    for (const JunctionId junction : foam.network.junctions()) {
        largest = std::max(largest, foam.positions[junction].cwiseAbs().maxCoeff());
    }
    double area = 0.0;
    for (const BubbleId bubble : foam.network.bubbles()) {
        area += foam.target_areas[bubble];
    }
    const double unit = std::sqrt(area / static_cast<double>(foam.network.bubble_count()));
    return std::max(
        kNewtonTolerance,
        std::min(kNewtonTolerancePerSize * largest / unit, kMaxToleranceRatio * tolerance));
}

NewtonSummary solve_whole(Work& work, Progress& progress) {
    if (progress.needs_restart) {
        work.whole.start_whole(work.foam, work.options.threads);
        progress.needs_restart = false;
    }
    const bool stops_if_slow = progress.solves_regions && progress.stops_if_slow;
    const double tolerance = newton_tolerance(work.foam, work.options.tolerance);
    NewtonSummary summary = newton(work.foam,
                                   work.whole,
                                   {.force_tolerance = tolerance,
                                    .area_tolerance = tolerance,
                                    .slow_ratio = stops_if_slow ? kSlowRatio : 1.0,
                                    .predicts_t1 = progress.solves_regions,
                                    .raises_precision_far = !progress.solves_regions,
                                    .thresholds = work.options.thresholds});
    progress.summary.iterations += summary.iterations;
    // The equilibrium accepts such errors. Usually rounding errors keep them from falling.
    if (summary.status == NewtonStatus::Stalled &&
        equilibrium_errors(work.foam).are_below(work.options.tolerance)) {
        summary.status = NewtonStatus::Converged;
    }
    return summary;
}

// Responds to the status with which Newton's method has ended.
void respond(Work& work, const NewtonSummary& newton_summary, Progress& progress) {
    const auto apply_rule = [&](const std::vector<FilmId>& films) {
        const int t1 = apply_t1_rule(work.foam, films, work.options.thresholds);
        count_t1(t1, progress);
        return t1;
    };
    switch (newton_summary.status) {
        case NewtonStatus::Converged:
            if (films_at_limit(work.foam) > 0) {  // their half angles are clamped: no equilibrium
                relax_all(work, false, progress);
            } else {
                progress.is_at_rest =
                    apply_rule(short_films(work.foam, work.options.thresholds)) == 0;
            }
            break;
        case NewtonStatus::FilmsNeedT1:
            apply_rule(newton_summary.films_for_t1);
            break;
        case NewtonStatus::Slow:
            break;
        case NewtonStatus::Stalled:
        case NewtonStatus::IterationLimit:
            relax_where_stalled(work, progress);
            break;
    }
}

// Runs one round: Newton's method for the whole foam, the response to its status, and then the
// defect regions on their own. The first round without defect regions begins with a relaxation.
Progress next_round(Work& work, Progress progress) {
    if (progress.rounds++ == kRoundsWithRegions) {
        progress.solves_regions = false;
        relax_all(work, false, progress);
    }
    if (work.foam.network.film_count() == 0) {  // every film has torn
        progress.is_at_rest = true;
        return progress;
    }
    const NewtonSummary newton_summary = solve_whole(work, progress);
    respond(work, newton_summary, progress);
    if (!progress.is_at_rest) {
        const std::size_t regions = solve_regions(work, kLaterDefects, progress);
        // If the step was slow without any defect region, progress is slow everywhere, and stopping
        // again would not help.
        progress.stops_if_slow = newton_summary.status != NewtonStatus::Slow || regions > 0;
    }
    return progress;
}

}  // namespace

EquilibriumSummary equilibrate(Foam& foam, const EquilibriumOptions& options) {
    const Positions start = foam.positions;
    if (foam.network.film_count() == 0) {  // empty, or only lone bubbles, which are circles already
        return conclude(foam, start, options, true, {});
    }
    Work work(foam, options);
    Progress progress = initial_phase(work);
    while (!progress.is_at_rest && progress.rounds < options.max_rounds) {
        if (options.on_round) {
            options.on_round();
        }
        progress = next_round(work, progress);
    }
    const EquilibriumSummary summary =
        conclude(foam, start, options, progress.is_at_rest, progress.summary);
    work.has_converged = summary.converged();
    return summary;
}

EquilibriumSummary conclude(Foam& foam,
                            const Positions& earlier,
                            const EquilibriumOptions& options,
                            bool has_stopped,
                            EquilibriumSummary summary) {
    undo_drift(foam, earlier);
    center_pressures(foam);
    rearm_grown_films(foam, options.thresholds);
    const EquilibriumErrors errors = equilibrium_errors(foam);
    summary.area_error = errors.area;
    summary.angle_error = errors.angle;
    summary.energy = energy(foam);
    if (has_stopped) {
        summary.status = errors.are_below(options.tolerance) ? EquilibriumStatus::Converged
                                                             : EquilibriumStatus::ToleranceMissed;
    }
    return summary;
}

}  // namespace foam
