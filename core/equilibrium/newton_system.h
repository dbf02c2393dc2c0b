#pragma once

#include "core/equilibrium/hessian.h"
#include "core/equilibrium/linear_solver.h"
#include "core/equilibrium/unknowns.h"

#include <Eigen/Core>

#include <optional>

namespace foam {

/// The linear system of Newton's method (E3) for some unknowns of a foam: the Hessian, regularized,
/// and its factor. It is kept between steps, so that the symbolic analysis, memory, and a factor
/// that is still good enough are used again.
class NewtonSystem {
  public:
    NewtonSystem() = default;
    NewtonSystem(const NewtonSystem&) = delete;  // the Hessian refers to the unknowns
    NewtonSystem& operator=(const NewtonSystem&) = delete;

    /// Prepares the system for a foam and its unknowns, without a factor. Must be called first, and
    /// again whenever the network has changed. `threads` as in parallel_for.
    void start(const Foam& foam, Unknowns unknowns, int threads);

    const Unknowns& unknowns() const { return unknowns_; }
    int threads() const { return threads_; }

    /// Returns true if a factor is available, of the foam's present or of an earlier state.
    bool has_factor() const { return has_factor_; }
    void drop_factor() { has_factor_ = false; }

    /// Returns the step -H⁻¹ r for a residual r of the foam. Factors the Hessian at the foam's
    /// present state if there is no factor; an older factor gives the step of the chord method.
    /// Returns zero, and leaves no factor, if the Hessian cannot be factored. Precondition: the
    /// foam has the network of `start`.
    Eigen::VectorXd step(const Foam& foam, const Eigen::VectorXd& residual);

    /// Changes to factors of double precision and drops the present factor. Returns false if they
    /// are of double precision already.
    bool raise_precision(const Foam& foam);

  private:
    void start_solver(const Foam& foam, Precision precision);
    void factor(const Foam& foam);
    Eigen::VectorXd solvable_part(const Foam& foam, Eigen::VectorXd residual) const;

    Unknowns unknowns_;
    std::optional<Hessian> hessian_;
    LinearSolver solver_;
    Precision precision_ = Precision::Double;
    int threads_ = 1;
    bool is_whole_ = false;  // no bubble is held
    bool has_factor_ = false;
};

}  // namespace foam
