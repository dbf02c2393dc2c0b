// SPDX-License-Identifier: Apache-2.0

#include "core/equilibrium/newton.h"

#include "core/equilibrium/moves.h"
#include "core/equilibrium/residual.h"
#include "core/geometry/elementary.h"
#include "core/geometry/max_or_nan.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace foam {

// Newton's method with backtracking line search (Nocedal and Wright, Numerical Optimization, 2006;
// paper section 4.1) on the gradient of L (E3). The merit function is the sum of squares of the
// dimensionless residual. The chord method reuses a factor as long as, at the measured rate of
// convergence, at most kStepsPerFactor further steps are expected. That many steps cost about as
// much as a new factor. If films need a T1 before a step, they are returned to the caller. The step
// is then not made, unless they are few films of a large foam (are_few).

namespace {

// A move by the fraction f of a step must reduce the sum of squares to less than (1 - f *
// kSufficientDecrease) times its value before.
constexpr double kSufficientDecrease = 1e-4;
constexpr double kMinStep = 1.0 / 64.0;  // smallest fraction of a step that is tried
// A factor is kept while at most this many further steps with it are expected. A new factor costs
// about as much as this many steps.
constexpr double kStepsPerFactor = 6.0;
// A new factor is kept if the first step with it leaves less than this share of the norm of the
// residual.
constexpr double kNewFactorRatio = 0.5;
// The foam is near equilibrium if all forces, in film tensions, and all relative area errors are
// below this number. T1s are then predicted from the step.
constexpr double kNearEquilibrium = 0.05;

// In a foam of a million bubbles, nearly every step would bring some films to a T1. If such a step
// were not made, the foam would make no progress. In a large foam (kLargeFoam), a step is therefore
// made if at most one film in kFilmsPerT1 needs a T1. These films get their T1s after the step. A
// limited step (limit_moves) shortens a film by at most about 40 % (NewtonOptions::largest_move).
constexpr std::size_t kFilmsPerT1 = 10'000;

// The residual at the foam's present state.
struct Evaluation {
    Eigen::VectorXd residual;
    ResidualNorms norms;
};

// The result of a line search.
struct Advance {
    bool moved = false;
    bool was_limited = false;  // the step was changed by limit_moves
    double ratio = 1.0;        // norm of the residual after the step, divided by the norm before
};

Evaluation evaluate(const Foam& foam, const NewtonSystem& system) {
    Evaluation current;
    current.residual = residual(foam, system.unknowns(), system.threads());
    current.norms = norms(foam, system.unknowns(), current.residual);
    return current;
}

// Returns the status if the method ends at the present state, or nothing if it continues.
std::optional<NewtonStatus> ending(const ResidualNorms& norms,
                                   int iterations,
                                   bool is_slow,
                                   const NewtonOptions& options) {
    if (std::isfinite(norms.squares) && norms.force < options.force_tolerance &&
        norms.area < options.area_tolerance) {
        return NewtonStatus::Converged;
    }
    if (iterations == options.max_iterations) {
        return NewtonStatus::IterationLimit;
    }
    return is_slow ? std::optional(NewtonStatus::Slow) : std::nullopt;
}

bool is_near_equilibrium(const ResidualNorms& norms) {
    return norms.force < kNearEquilibrium && norms.area < kNearEquilibrium;
}

// Returns true if the step is made although these films need a T1.
bool are_few(const std::vector<FilmId>& films_for_t1, const Unknowns& unknowns) {
    const std::size_t films = unknowns.films.size();
    return films >= kLargeFoam && films_for_t1.size() <= films / kFilmsPerT1;
}

std::vector<FilmId> films_for_t1(const Foam& foam,
                                 const Unknowns& unknowns,
                                 const Eigen::VectorXd& step,
                                 const ResidualNorms& norms,
                                 const NewtonOptions& options) {
    return options.predicts_t1 && is_near_equilibrium(norms)
               ? films_staying_short(foam, unknowns, step, options.thresholds)
               : collapsing_films(foam, unknowns, step, options.thresholds);
}

// Moves the foam along the step by the first of the fractions 1, 1/2, 1/4 ... that reduces the
// residual sufficiently. If no fraction does, restores the foam and returns false.
bool backtrack(Foam& foam,
               const NewtonSystem& system,
               const Eigen::VectorXd& step,
               Evaluation& current) {
    const State start = state_of(foam, system.unknowns());
    for (double fraction = 1.0; fraction >= kMinStep; fraction *= 0.5) {
        set_state(foam, system.unknowns(), start, step, fraction);
        Evaluation trial = evaluate(foam, system);
        if (trial.norms.squares < (1.0 - kSufficientDecrease * fraction) * current.norms.squares) {
            current = std::move(trial);
            return true;
        }
    }
    // A step of zeros is passed, because 0 times a step that is not finite would be NaN and would
    // not restore the foam.
    set_state(foam, system.unknowns(), start, Eigen::VectorXd::Zero(step.size()), 0.0);
    return false;
}

// Backtracks along the limited step. If that fails, backtracks along the original step, since a
// limited step may not be a descent direction.
Advance line_search(Foam& foam,
                    const NewtonSystem& system,
                    const Eigen::VectorXd& step,
                    double largest_move,
                    Evaluation& current) {
    const double squares_before = current.norms.squares;
    Advance advance;
    Eigen::VectorXd limited = step;
    advance.was_limited = limit_moves(foam, system.unknowns(), largest_move, limited);
    advance.moved = backtrack(foam, system, limited, current) ||
                    (advance.was_limited && backtrack(foam, system, step, current));
    advance.ratio = std::sqrt(current.norms.squares / squares_before);
    return advance;
}

// Returns true if keeping the factor is expected to be cheaper than renewing it. The first step
// with a new factor is a Newton step, not a chord step, so its ratio says little about the
// convergence of later chord steps. The ratio of this first step is therefore only compared with a
// fixed limit.
bool is_worth_keeping(const Advance& advance,
                      bool is_chord_step,
                      const ResidualNorms& norms,
                      const NewtonOptions& options) {
    if (!advance.moved || advance.was_limited) {
        return false;
    }
    if (!is_chord_step) {
        return advance.ratio < kNewFactorRatio;
    }
    const double log_reduction = ieee::log(
        std::max(norms.force / options.force_tolerance, norms.area / options.area_tolerance));
    return log_reduction < -kStepsPerFactor * ieee::log(advance.ratio);
}

bool may_raise_precision(const ResidualNorms& norms, const NewtonOptions& options) {
    return options.raises_precision_far || is_near_equilibrium(norms);
}

}  // namespace

NewtonSummary newton(Foam& foam, NewtonSystem& system, const NewtonOptions& options) {
    NewtonSummary summary;
    Evaluation current = evaluate(foam, system);
    std::optional<NewtonStatus> end = ending(current.norms, 0, false, options);
    while (!end) {
        const bool is_chord_step = system.has_factor();
        const Eigen::VectorXd step = system.step(foam, current.residual);
        summary.films_for_t1 = films_for_t1(foam, system.unknowns(), step, current.norms, options);
        const bool need_t1 = !summary.films_for_t1.empty();
        if (need_t1 && !are_few(summary.films_for_t1, system.unknowns())) {
            end = NewtonStatus::FilmsNeedT1;
            break;
        }
        const Advance advance = line_search(foam, system, step, options.largest_move, current);
        summary.iterations += advance.moved ? 1 : 0;
        if (!is_worth_keeping(advance, is_chord_step, current.norms, options)) {
            system.drop_factor();
        }
        // If a step with a new factor makes no progress, the precision of the factor may be the
        // reason. If films need a T1, they are the likelier reason.
        if (!advance.moved && !is_chord_step &&
            (need_t1 ||
             !(may_raise_precision(current.norms, options) && system.raise_precision(foam)))) {
            end = NewtonStatus::Stalled;
            break;
        }
        if (need_t1) {
            end = NewtonStatus::FilmsNeedT1;
            break;
        }
        const bool is_slow = advance.moved && !is_chord_step && advance.ratio > options.slow_ratio;
        end = ending(current.norms, summary.iterations, is_slow, options);
    }
    wrap(foam, system.unknowns());
    summary.status = *end;
    summary.residual = max_or_nan(current.norms.force, current.norms.area);
    return summary;
}

NewtonSummary newton(Foam& foam, const Unknowns& unknowns, const NewtonOptions& options) {
    NewtonSystem system;
    system.start(foam, unknowns, 0);
    return newton(foam, system, options);
}

}  // namespace foam
