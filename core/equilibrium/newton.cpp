#include "core/equilibrium/newton.h"

#include "core/equilibrium/hessian.h"
#include "core/equilibrium/linear_solver.h"
#include "core/equilibrium/moves.h"
#include "core/equilibrium/residual.h"

#include <algorithm>
#include <cmath>

namespace foam {

namespace {

constexpr double kSufficientDecrease = 1e-4;  // of the sum of squares, per unit of the step
constexpr double kSmallestStep = 1.0 / 64.0;
// Relative to the largest diagonal entry of its kind: takes care of the null modes (E3).
constexpr double kRegularization = 1e-9;

class Iteration {
  public:
    Iteration(Foam& foam, const Unknowns& unknowns, const NewtonOptions& options)
        : foam_(foam),
          unknowns_(unknowns),
          options_(options),
          hessian_(foam.network, unknowns),
          solver_(foam, unknowns, options.threads),
          residual_(residual(foam, unknowns)),
          norms_(norms(foam, unknowns, residual_)) {}

    const ResidualNorms& present() const { return norms_; }

    bool converged() const {
        return std::isfinite(norms_.squares) && norms_.force < options_.force_tolerance &&
               norms_.area < options_.area_tolerance;
    }

    Eigen::VectorXd full_step() {
        Eigen::SparseMatrix<double> matrix = hessian_.evaluate(foam_);
        const auto rows = static_cast<Eigen::Index>(2 * unknowns_.junctions.size());
        for (Eigen::Index row = 0; row < matrix.rows(); ++row) {
            double& diagonal = matrix.coeffRef(row, row);
            diagonal += row < rows ? kRegularization * foam_.film_tension
                                   : -kRegularization * (std::abs(diagonal) + 1e-12);
        }
        if (!solver_.factor(matrix)) {
            return Eigen::VectorXd::Zero(residual_.size());
        }
        return -solver_.solve(residual_);
    }

    // Goes along the step as far as the residual shrinks; false, unmoved, where it does not.
    bool advance(const Eigen::VectorXd& step) {
        const State start = state_of(foam_, unknowns_);
        for (double fraction = 1.0; fraction >= kSmallestStep; fraction *= 0.5) {
            set_state(foam_, unknowns_, start, step, fraction);
            Eigen::VectorXd trial = residual(foam_, unknowns_);
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

  private:
    Foam& foam_;
    const Unknowns& unknowns_;
    const NewtonOptions& options_;
    Hessian hessian_;
    LinearSolver solver_;
    Eigen::VectorXd residual_;
    ResidualNorms norms_;
};

}  // namespace

NewtonSummary newton(Foam& foam, const Unknowns& unknowns, const NewtonOptions& options) {
    Iteration iteration(foam, unknowns, options);
    NewtonSummary summary;
    while (true) {
        summary.residual = std::max(iteration.present().force, iteration.present().area);
        if (iteration.converged()) {
            summary.status = NewtonStatus::Converged;
            break;
        }
        if (summary.iterations == options.max_iterations) {
            summary.status = NewtonStatus::IterationLimit;
            break;
        }
        Eigen::VectorXd step = iteration.full_step();
        summary.collapsing = collapsing_films(foam, unknowns, step, options.thresholds);
        if (!summary.collapsing.empty()) {
            summary.status = NewtonStatus::FilmsCollapse;
            break;
        }
        limit_moves(foam, unknowns, options.largest_move, step);
        if (!iteration.advance(step)) {
            summary.status = NewtonStatus::Stalled;
            break;
        }
        ++summary.iterations;
    }
    wrap(foam, unknowns);
    return summary;
}

}  // namespace foam
