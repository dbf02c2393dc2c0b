#pragma once

#include "core/equilibrium/unknowns.h"
#include "core/foam/foam.h"
#include "core/sparse/sparse_ldlt.h"

#include <Eigen/SparseCore>

#include <vector>

namespace foam {

/// Returns the positions of the unknowns, in the order of their rows: of a junction its own, of the
/// pressure of a bubble the mean of its junctions, of the half angle of an outer film the middle of
/// its chord.
std::vector<SolverNode> solver_nodes(const Foam& foam, const Unknowns& unknowns);

/// The precision of a factor. Single precision takes half the time and memory, and is enough for
/// steps whose residual is computed in double precision, unless a pivot is nearly zero.
enum class Precision { Single, Double };

/// A direct solver for the Hessian of E3, given as a lower triangle. Near a stable state it is
/// quasi-definite, so that no pivoting is needed.
class LinearSolver {
  public:
    /// Prepares for a network. Positions only guide the order of elimination, so that everything
    /// stays valid while the foam moves and its network is the same. `threads` as in parallel_for.
    void start(const Foam& foam, const Unknowns& unknowns, Precision precision, int threads = 0);

    /// Factors a matrix; all matrices since `start` have the same pattern. Returns false if a pivot
    /// vanished or the factor would take too much memory: then there is none to solve with.
    bool factor(const Eigen::SparseMatrix<double>& matrix);

    /// Solves with the factor, to about six digits if it is of single precision.
    Eigen::VectorXd solve(const Eigen::VectorXd& right_hand_side) const;

  private:
    std::vector<SolverNode> nodes_;
    Domain domain_;
    Precision precision_ = Precision::Double;
    int threads_ = 1;
    bool analyzed_ = false;
    SparseLdlt<float> single_;
    SparseLdlt<double> double_;
};

}  // namespace foam
