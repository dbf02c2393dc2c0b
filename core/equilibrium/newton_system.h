// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/equilibrium/hessian.h"
#include "core/equilibrium/linear_solver.h"
#include "core/equilibrium/unknowns.h"

#include <Eigen/Core>

#include <optional>

namespace foam {

/// The linear system of Newton's method (E3) for some unknowns of a foam: the regularized Hessian
/// and its factor. The caller keeps this object between steps in order to reuse the symbolic
/// analysis, the memory, and a factor that is still good enough.
class NewtonSystem {
  public:
    NewtonSystem() = default;
    NewtonSystem(const NewtonSystem&) = delete;  // the Hessian refers to the unknowns
    NewtonSystem& operator=(const NewtonSystem&) = delete;

    /// Prepares the system for the given unknowns of a foam. Afterwards no factor is available.
    /// This function or `start_whole` must be called before all other functions, and again whenever
    /// the network has changed.
    /// `threads` has the same meaning as in parallel_for.
    void start(const Foam& foam, Unknowns unknowns, int threads);

    /// Prepares the system for all unknowns of a foam. Does less work than `start` if the system
    /// was last prepared for a similar network. Keeps the analysis, and the factor of the earlier
    /// state if there is one, under three conditions:
    /// - this function also made the last preparation;
    /// - the connections of the network and the number of threads are the same;
    /// - the precision has not been raised since (raise_precision).
    ///
    /// If one of them is not met, and the number of outer films is the same, the order of
    /// elimination is repaired, if possible (LdltOptions::keeps_order). In both cases, the steps
    /// depend on earlier calls.
    void start_whole(const Foam& foam, int threads);

    const Unknowns& unknowns() const { return unknowns_; }
    int threads() const { return threads_; }

    /// Returns true if a factor is available, either of the present or of an earlier state of the
    /// foam.
    bool has_factor() const { return has_factor_; }
    /// Makes the next step use a new factor.
    void drop_factor() { has_factor_ = false; }

    /// Returns the step -H⁻¹ r for a residual r of the foam, where H is the regularized Hessian. If
    /// no bubble is held (every bubble is among the unknowns), the step does not change the mean
    /// position of the junctions. Factors H at the present state of the foam if no factor is
    /// available. With an older factor, this is the step of the chord method. If H cannot be
    /// factored, returns a zero step, and no factor is available afterwards. Precondition: the foam
    /// has the network of the last start.
    Eigen::VectorXd step(const Foam& foam, const Eigen::VectorXd& residual);

    /// Switches to factors in double precision and drops the present factor. Returns false and does
    /// nothing if factors are in double precision already.
    bool raise_precision(const Foam& foam);

  private:
    void prepare(const Foam& foam, Unknowns unknowns, int threads);
    Precision first_precision() const;
    void start_solver(const Foam& foam, Precision precision);
    void factor(const Foam& foam);
    Eigen::VectorXd solvable_part(const Foam& foam, Eigen::VectorXd residual) const;

    Unknowns unknowns_;
    std::optional<Hessian> hessian_;
    std::optional<Network> network_;  // the network of the last start, if that was start_whole
    LinearSolver solver_;
    Precision precision_ = Precision::Double;
    int threads_ = 1;
    bool keeps_order_ = false;
    bool is_whole_ = false;  // no bubble is held
    bool has_factor_ = false;
};

}  // namespace foam
