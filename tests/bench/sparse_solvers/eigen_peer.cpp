// SPDX-License-Identifier: Apache-2.0

#include "tests/bench/sparse_solvers/peers.h"

#include <Eigen/SparseCholesky>

namespace foam::bench {

Result eigen_result(const System& system) {
    Result result{.solver = "Eigen SimplicialLDLT, AMD"};
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver;
    result.analysis_seconds = min_seconds([&] { solver.analyzePattern(system.lower); });
    result.factor_seconds = min_seconds([&] { solver.factorize(system.lower); });
    result.positions = solver.permutationP().indices();
    // L is stored without its diagonal, and with an index for each number.
    const auto rows = static_cast<double>(system.lower.rows());
    const auto below = static_cast<double>(solver.matrixL().nestedExpression().nonZeros());
    result.numbers = below + rows;
    result.bytes = below * (sizeof(double) + sizeof(int)) + rows * (sizeof(double) + sizeof(int));
    if (solver.info() == Eigen::Success) {
        Eigen::VectorXd x;
        result.solve_seconds = min_seconds([&] { x = solver.solve(system.right_side); });
        result.residual = residual(system.lower, x, system.right_side);
    }
    return result;
}

}  // namespace foam::bench
