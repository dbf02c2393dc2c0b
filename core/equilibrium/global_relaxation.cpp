// SPDX-License-Identifier: Apache-2.0

#include "core/equilibrium/global_relaxation.h"

#include "core/equilibrium/defect_regions.h"
#include "core/equilibrium/residual.h"
#include "core/equilibrium/untangle.h"
#include "core/foam/measure.h"

namespace foam {

// Newton's method (E3) converges reliably only near equilibrium. Relaxation (E4) reaches such a
// state from a raw diagram, but converges slowly, so it is ended after a fixed number of sweeps. In
// two cases, Newton's method sometimes finds no equilibrium afterwards:
// - Many films are at the limit of their half angle, where the clamped arc no longer satisfies
//   Laplace-Young's law.
// - A patch has large errors.
// In these cases, further passes follow, which keep the pressures found so far. The criteria for
// further passes are our own (measurements: NOTES.md).

namespace {

// A pass is one call of `relax` for the whole foam. The first pass may leave some inner films at
// the limit of their half angle (80 degrees, E3), for example around a two-sided bubble. If there
// are at most this many such films, they are no reason for a further pass.
constexpr int kFewAtLimit = 10;
constexpr int kMaxFurtherPasses = 10;  // largest number of passes after the first one

// Returns true if the foam is a patch with a large error for which find_defect_regions returns no
// region. There are two possible reasons:
// - The regions would contain more than DefectOptions::largest_fraction of the bubbles.
// - There is no defect: the large error is an error of Laplace-Young's law at an outer film,
//   which does not count as a defect.
// Always returns false for a torus, so that relax_globally does not reset the pressures for this
// reason. Several resets in one equilibration would collapse the two-sided bubbles of the torus.
bool is_patch_far_from_equilibrium(const Foam& foam, int threads) {
    if (!foam.domain.is_plane()) {
        return false;
    }
    const Unknowns all = all_unknowns(foam.network);
    const Eigen::VectorXd r = residual(foam, all, threads);
    const ResidualNorms worst = norms(foam, all, r);
    const bool is_near = worst.force < DefectOptions{}.force && worst.area < DefectOptions{}.area;
    return !is_near && find_defect_regions(foam, all, r, {}).empty();
}

}  // namespace

RelaxationSummary relax_globally(Foam& foam,
                                 const GlobalRelaxationOptions& options,
                                 SoftFoam& memory) {
    const bool restarts = untangle(foam) > 0 || options.restarts || films_at_limit(foam) > 0 ||
                          is_patch_far_from_equilibrium(foam, options.threads);
    RelaxationOptions pass{
        .sweeps = options.sweeps, .restarts = restarts, .thresholds = options.thresholds};
    RelaxationSummary sum = relax(foam, all_unknowns(foam.network), pass, memory);
    pass.sweeps = options.further_sweeps;
    pass.restarts = false;
    const bool has_many_at_limit = films_at_limit(foam) > kFewAtLimit;
    const auto needs_further_pass = [&] {
        return is_patch_far_from_equilibrium(foam, options.threads) ||
               (has_many_at_limit && films_at_limit(foam) > 0);
    };
    for (int k = 0; k < kMaxFurtherPasses && needs_further_pass(); ++k) {
        const RelaxationSummary further = relax(foam, all_unknowns(foam.network), pass, memory);
        sum.sweeps += further.sweeps;
        sum.t1 += further.t1;
    }
    return sum;
}

}  // namespace foam
