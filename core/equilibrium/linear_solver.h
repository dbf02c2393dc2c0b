// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/equilibrium/unknowns.h"
#include "core/foam/foam.h"
#include "core/sparse/sparse_ldlt.h"

#include <Eigen/SparseCore>

#include <vector>

namespace foam {

/// Returns the solver nodes (SolverNode in core/sparse/node_graph.h) of the unknowns, in the order
/// of their rows. The node of a junction is at the junction. The node of a bubble's pressure is at
/// the mean of the bubble's junctions. The node of an outer film's half angle is at the middle of
/// the film's chord. The name of a node is a hash of identities of bubbles: the three at a
/// junction, the bubble itself, or the bubble inside an outer film and those at its ends.
std::vector<SolverNode> solver_nodes(const Foam& foam, const Unknowns& unknowns);

/// The precision of a factor. Single precision takes half the memory and less time. It is
/// sufficient for the steps of Newton's method, because the residual is computed in double
/// precision. A matrix with a pivot that is nearly zero is an exception and requires double
/// precision.
enum class Precision { Single, Double };

/// A direct solver for linear systems with the Hessian of E3. The Hessian is given as a lower
/// triangle, and NewtonSystem adds small numbers to its diagonal. Near a stable state, the
/// resulting matrix is quasi-definite: positive definite in the positions and half angles, and
/// negative definite in the pressures. No pivoting is then needed.
class LinearSolver {
  public:
    /// Prepares the solver for some unknowns of a foam. The preparation stays valid when the foam
    /// moves, as long as its network does not change, because positions only guide the order of
    /// elimination. `threads` has the same meaning as in parallel_for. If `keeps_order` is true,
    /// the order of elimination of the last start with this precision is repaired, if possible
    /// (LdltOptions::keeps_order); this suits the unknowns of the same foam after a few T1s and
    /// T2s.
    void start(const Foam& foam,
               const Unknowns& unknowns,
               Precision precision,
               int threads = 0,
               bool keeps_order = false);

    /// Factors a matrix. Returns false if a pivot is zero or not finite, or if the factor would
    /// take too much memory; no factor is available then. Precondition: `start` has been called,
    /// and all matrices since then have the same sparsity pattern.
    bool factor(const Eigen::SparseMatrix<double>& matrix);

    /// Returns the solution for a right-hand side. If the factor is in single precision, the
    /// solution has only a few correct digits, fewer in large systems (core/sparse/README.md).
    /// Precondition: `factor` has succeeded.
    Eigen::VectorXd solve(const Eigen::VectorXd& right_hand_side) const;

  private:
    std::vector<SolverNode> nodes_;
    Domain domain_;
    Precision precision_ = Precision::Double;
    int threads_ = 1;
    bool keeps_order_ = false;
    bool analyzed_ = false;
    SparseLdlt<float> single_;
    SparseLdlt<double> double_;
};

}  // namespace foam
