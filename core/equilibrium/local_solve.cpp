// SPDX-License-Identifier: Apache-2.0

#include "core/equilibrium/local_solve.h"

#include "core/equilibrium/newton.h"
#include "core/equilibrium/relaxation.h"
#include "core/equilibrium/residual.h"
#include "core/foam/t1_rule.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace foam {

// After a T1, a few equations are strongly nonlinear and would shorten the steps of Newton's method
// for the whole foam. Solving such equations first, with all other unknowns held, is nonlinear
// elimination (P. J. Lanzkron, D. J. Rose and J. T. Wilkes, An analysis of approximate nonlinear
// elimination, SIAM Journal on Scientific Computing 17, 1996). The equations are chosen by their
// residuals (defect_regions.h). Relaxation (E4) of a region in which Newton's method stalls is our
// own addition.

namespace {

// The tolerance of forces, in film tensions, and of relative area errors. It is loose, since the
// surroundings of the region are held and will move later.
constexpr double kTolerance = 1e-3;
constexpr int kMaxIterations = 12;     // largest number of Newton steps in a round
constexpr int kMaxRounds = 5;          // largest number of rounds
constexpr int kRelaxationSweeps = 30;  // sweeps in a region in which Newton's method stalls
// A defect whose force is at least this share of the largest force is among the worst. So is a
// defect whose area error is at least this share of the largest area error.
constexpr double kWorstFraction = 0.2;

// Erases bubbles that are no longer in the network. This is only a precaution: at present,
// the T1 rule removes no bubble.
void remove_dead(const Network& network, DefectRegion& region) {
    std::erase_if(region, [&](BubbleId bubble) { return !network.is_live(bubble); });
}

// Solves one region in rounds. Each round runs Newton's method. If the method requests T1s, they
// are made before the next round. If it stalls or reaches its limit of iterations, the region is
// relaxed the first time; the second time, the function gives up. Returns the number of T1s.
int solve_region(Foam& foam,
                 DefectRegion region,
                 const TopologyThresholds& thresholds,
                 RegionBuffers& buffers) {
    const NewtonOptions options{.max_iterations = kMaxIterations,
                                .force_tolerance = kTolerance,
                                .area_tolerance = kTolerance,
                                .thresholds = thresholds};
    int t1 = 0;
    bool was_relaxed = false;
    for (int round = 0; round < kMaxRounds; ++round) {
        remove_dead(foam.network, region);
        if (region.empty()) {
            break;
        }
        buffers.system.start(foam, unknowns_around(foam.network, region), 1);
        const NewtonSummary summary = newton(foam, buffers.system, options);
        if (summary.status == NewtonStatus::FilmsNeedT1) {
            t1 += apply_t1_rule(foam, summary.films_for_t1, thresholds);
        } else if (summary.status == NewtonStatus::Converged || was_relaxed) {
            break;
        } else {
            const RelaxationOptions relaxation{
                .sweeps = kRelaxationSweeps, .restarts = false, .thresholds = thresholds};
            t1 += relax(foam, buffers.system.unknowns(), relaxation, buffers.soft).t1;
            was_relaxed = true;
        }
    }
    return t1;
}

}  // namespace

LocalSummary solve_defect_regions(Foam& foam,
                                  const DefectOptions& defects,
                                  const EquilibriumOptions& options,
                                  RegionBuffers& buffers) {
    const Unknowns all = all_unknowns(foam.network);
    const std::vector<DefectRegion> regions =
        find_defect_regions(foam, all, residual(foam, all, options.threads), defects);
    LocalSummary summary{.regions = regions.size()};
    for (const DefectRegion& region : regions) {
        summary.t1 += solve_region(foam, region, options.thresholds, buffers);
    }
    return summary;
}

std::vector<DefectRegion> worst_regions(const Foam& foam, int threads, int fewest_rings) {
    const Unknowns all = all_unknowns(foam.network);
    const Eigen::VectorXd r = residual(foam, all, threads);
    const ResidualNorms worst = norms(foam, all, r);
    DefectOptions options;
    options.force = std::max(options.force, kWorstFraction * worst.force);
    options.area = std::max(options.area, kWorstFraction * worst.area);
    std::vector<DefectRegion> regions;
    for (options.rings = kWorstRings; regions.empty() && options.rings >= fewest_rings;
         --options.rings) {
        regions = find_defect_regions(foam, all, r, options);
    }
    return regions;
}

int relax_regions(Foam& foam,
                  std::vector<DefectRegion> regions,
                  const EquilibriumOptions& options,
                  RegionBuffers& buffers) {
    const RelaxationOptions relaxation{
        .sweeps = options.relaxation_sweeps, .restarts = false, .thresholds = options.thresholds};
    int t1 = 0;
    for (DefectRegion& region : regions) {
        remove_dead(foam.network, region);
        if (!region.empty()) {
            t1 += relax(foam, unknowns_around(foam.network, region), relaxation, buffers.soft).t1;
        }
    }
    return t1;
}

}  // namespace foam
