#pragma once

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

namespace foam {

/// Factors the Hessian of E3, lower triangle given, as L D Lᵀ with a fill-reducing ordering and no
/// pivoting: near a stable state the matrix is quasi-definite.
class LinearSolver {
  public:
    /// Shares the ordering with the last matrix unless told that the pattern is new.
    /// False where a pivot vanished.
    bool factor(const Eigen::SparseMatrix<double>& matrix, bool new_pattern);

    Eigen::VectorXd solve(const Eigen::VectorXd& right_hand_side) const {
        return factors_.solve(right_hand_side);
    }

  private:
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower> factors_;
};

}  // namespace foam
