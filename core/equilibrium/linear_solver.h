#pragma once

#include "core/equilibrium/sparse_ldlt.h"
#include "core/equilibrium/unknowns.h"
#include "core/foam/foam.h"

#include <Eigen/SparseCore>

#include <vector>

namespace foam {

/// The unknowns of a foam where they stand: junctions at their positions, the pressure of a bubble
/// in the middle of its junctions. In the order of the rows.
std::vector<SolverNode> solver_nodes(const Foam& foam, const Unknowns& unknowns);

/// Solves with the Hessian of E3, lower triangle given: near a stable state it is quasi-definite,
/// so that no pivoting is needed.
class LinearSolver {
  public:
    /// Positions only guide the order of elimination: the solver stays good while the foam moves,
    /// and as long as its network is the same. 0 threads are as many as the machine runs at once.
    LinearSolver(const Foam& foam, const Unknowns& unknowns, int threads = 0);

    /// All matrices have the pattern of the first. False where a pivot vanished: there is then
    /// nothing to solve with.
    bool factor(const Eigen::SparseMatrix<double>& matrix);

    Eigen::VectorXd solve(const Eigen::VectorXd& right_hand_side) const {
        return factors_.solve(right_hand_side);
    }

  private:
    std::vector<SolverNode> nodes_;
    Torus torus_;
    int threads_;
    bool analyzed_ = false;
    SparseLdlt factors_;
};

}  // namespace foam
