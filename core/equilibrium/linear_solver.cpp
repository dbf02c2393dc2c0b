#include "core/equilibrium/linear_solver.h"

namespace foam {

bool LinearSolver::factor(const Eigen::SparseMatrix<double>& matrix, bool new_pattern) {
    if (new_pattern) {
        factors_.analyzePattern(matrix);
    }
    factors_.factorize(matrix);
    return factors_.info() == Eigen::Success;
}

}  // namespace foam
