#include "core/equilibrium/newton.h"

#include "core/equilibrium/moves.h"
#include "core/equilibrium/residual.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace foam {

namespace {

constexpr double kSufficientDecrease = 1e-4;  // of the sum of squares, per unit of the step
constexpr double kSmallestStep = 1.0 / 64.0;
// Takes care of the null modes (E3): of the film tension for junctions, of the diagonal for
// pressures. Small against the softest shear of the foam, and large against rounding in the factor.
// A small foam may have a null mode of its junctions that only a later pressure holds: its pivot is
// then this small and the next one as large as 1 over it. That takes double precision.
constexpr double kSingleRegularization = 1e-6;
constexpr double kDoubleRegularization = 1e-7;
constexpr int kFewUnknowns = 500;  // too few for single precision to pay
// A factor is kept while no more than so many further steps are expected. Renewing it takes about
// as long as this many.
constexpr double kStepsPerFactor = 6.0;
constexpr double kNearEquilibrium = 0.05;  // largest force and area error at which T1 are foreseen

}  // namespace

// One call of NewtonSolver::run.
class NewtonRun {
  public:
    NewtonRun(Foam& foam, NewtonSolver& solver)
        : foam_(foam),
          solver_(solver),
          unknowns_(solver.unknowns_),
          options_(solver.options_),
          residual_(residual(foam, unknowns_, options_.threads)),
          norms_(norms(foam, unknowns_, residual_)) {}

    NewtonSummary run() {
        while (!is_over()) {
            iterate();
        }
        wrap(foam_, unknowns_);
        summary_.residual = std::max(norms_.force, norms_.area);
        return summary_;
    }

  private:
    bool is_over() {
        if (std::isfinite(norms_.squares) && norms_.force < options_.force_tolerance &&
            norms_.area < options_.area_tolerance) {
            stop(NewtonStatus::Converged);
        } else if (summary_.iterations == options_.max_iterations) {
            stop(NewtonStatus::IterationLimit);
        }
        return over_;
    }

    void stop(NewtonStatus status) {
        summary_.status = status;
        over_ = true;
    }

    void iterate() {
        const bool is_chord_step = solver_.has_factor_;
        const Eigen::VectorXd step = full_step();
        summary_.collapsing = films_for_t1(step);
        if (!summary_.collapsing.empty()) {
            stop(NewtonStatus::FilmsCollapse);
            return;
        }
        const double before = norms_.squares;
        const bool advanced = advance_safely(step);
        const double ratio = std::sqrt(norms_.squares / before);
        solver_.has_factor_ = advanced && !cut_ && is_worth_keeping(ratio, is_chord_step);
        summary_.iterations += advanced ? 1 : 0;
        if (is_chord_step) {
            return;
        }
        if (!advanced) {
            give_up_or_refine();
        } else if (ratio > options_.slow_ratio) {
            stop(NewtonStatus::Slow);
        }
    }

    // Where Newton's step leads nowhere, the factor may be to blame.
    void give_up_or_refine() {
        if (solver_.precision_ == Precision::Double) {
            stop(NewtonStatus::Stalled);
        } else {
            solver_.start_linear_solver(foam_, Precision::Double);
        }
    }

    // Newton's step or, with a factor from before, the chord method's; zero where there is none.
    Eigen::VectorXd full_step() {
        if (!solver_.has_factor_) {
            solver_.renew_factor(foam_);
        }
        if (!solver_.has_factor_) {
            return Eigen::VectorXd::Zero(residual_.size());
        }
        Eigen::VectorXd step = -solver_.solver_.solve(solvable_part());
        if (solver_.is_whole_) {
            hold_mean_position(step);
        }
        return step;
    }

    // Nothing holds a foam as a whole where it is. Without this, rounding in a factor of a softly
    // sheared foam now and then throws all of it by a bubble's size.
    void hold_mean_position(Eigen::VectorXd& step) const {
        const auto junctions = static_cast<Eigen::Index>(unknowns_.junctions.size());
        auto moves = step.head(2 * junctions).reshaped(2, junctions);
        moves.colwise() -= Vec2(moves.rowwise().mean());
    }

    // What no motion of the whole foam and, on a torus, no common pressure can change is taken out,
    // evenly: the sums of forces and of areas, which are zero but for rounding.
    Eigen::VectorXd solvable_part() const {
        const auto junctions = static_cast<Eigen::Index>(unknowns_.junctions.size());
        const auto bubbles = static_cast<Eigen::Index>(unknowns_.bubbles.size());
        Eigen::VectorXd r = residual_;
        if (solver_.is_whole_) {
            auto forces = r.head(2 * junctions).reshaped(2, junctions);
            forces.colwise() -= Vec2(forces.rowwise().mean());
        }
        if (solver_.is_whole_ && foam_.network.ghost() == kNone<BubbleId>) {
            r.tail(bubbles).array() -= r.tail(bubbles).mean();
        }
        return r;
    }

    std::vector<FilmId> films_for_t1(const Eigen::VectorXd& step) const {
        const bool is_near = options_.foresees_t1 && norms_.force < kNearEquilibrium &&
                             norms_.area < kNearEquilibrium;
        return is_near ? closing_films(foam_, unknowns_, step, options_.thresholds)
                       : collapsing_films(foam_, unknowns_, step, options_.thresholds);
    }

    // Goes along the step, its moves limited, or else, since that may be no way down, along the
    // step as it is.
    bool advance_safely(const Eigen::VectorXd& step) {
        Eigen::VectorXd limited = step;
        cut_ = limit_moves(foam_, unknowns_, options_.largest_move, limited);
        return advance(limited) || (cut_ && advance(step));
    }

    // Goes along the step as far as the residual shrinks; false, unmoved, where it does not.
    bool advance(const Eigen::VectorXd& step) {
        const State start = state_of(foam_, unknowns_);
        for (double fraction = 1.0; fraction >= kSmallestStep; fraction *= 0.5) {
            set_state(foam_, unknowns_, start, step, fraction);
            Eigen::VectorXd trial = residual(foam_, unknowns_, options_.threads);
            const ResidualNorms trial_norms = norms(foam_, unknowns_, trial);
            if (trial_norms.squares < (1.0 - kSufficientDecrease * fraction) * norms_.squares) {
                residual_ = std::move(trial);
                norms_ = trial_norms;
                return true;
            }
        }
        set_state(foam_, unknowns_, start, step, 0.0);
        return false;
    }

    // From the step that was taken last. One with a new factor tells little of those to come.
    bool is_worth_keeping(double ratio, bool is_chord_step) const {
        if (!is_chord_step) {
            return ratio < 0.5;
        }
        const double digits = std::log(std::max(norms_.force / options_.force_tolerance,
                                                norms_.area / options_.area_tolerance));
        return digits < -kStepsPerFactor * std::log(ratio);
    }

    Foam& foam_;
    NewtonSolver& solver_;
    const Unknowns& unknowns_;
    const NewtonOptions& options_;
    Eigen::VectorXd residual_;
    ResidualNorms norms_;
    NewtonSummary summary_;
    bool cut_ = false;  // the last step was limited
    bool over_ = false;
};

void NewtonSolver::start(const Foam& foam, Unknowns unknowns) {
    unknowns_ = std::move(unknowns);
    is_whole_ = unknowns_.bubbles.size() == foam.network.bubble_count();
    hessian_.emplace(foam.network, unknowns_);
    start_linear_solver(foam,
                        unknowns_.size() < kFewUnknowns ? Precision::Double : Precision::Single);
}

void NewtonSolver::start_linear_solver(const Foam& foam, Precision precision) {
    precision_ = precision;
    solver_.start(foam, unknowns_, precision, options_.threads);
    has_factor_ = false;
}

NewtonSummary NewtonSolver::run(Foam& foam) {
    return NewtonRun(foam, *this).run();
}

void NewtonSolver::renew_factor(const Foam& foam) {
    hessian_->evaluate(foam, options_.threads);
    const double regularization =
        precision_ == Precision::Single ? kSingleRegularization : kDoubleRegularization;
    for (int row = 0; row < unknowns_.size(); ++row) {
        double& diagonal = hessian_->diagonal(row);
        const bool is_pressure =
            row >= unknowns_.first_pressure_row() && row < unknowns_.first_angle_row();
        diagonal += is_pressure ? -regularization * (std::abs(diagonal) + 1e-12)
                                : regularization * foam.film_tension;
    }
    has_factor_ = solver_.factor(hessian_->matrix());
}

NewtonSummary newton(Foam& foam, const Unknowns& unknowns, const NewtonOptions& options) {
    NewtonSolver solver(options);
    solver.start(foam, unknowns);
    return solver.run(foam);
}

}  // namespace foam
