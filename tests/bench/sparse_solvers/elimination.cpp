// SPDX-License-Identifier: Apache-2.0

#include "tests/bench/sparse_solvers/elimination.h"

#include <utility>

namespace foam::bench {

Elimination count_elimination(const Eigen::SparseMatrix<double>& lower,
                              const Permutation& positions) {
    Eigen::SparseMatrix<double> upper(lower.rows(), lower.cols());
    upper.selfadjointView<Eigen::Upper>() = lower.selfadjointView<Eigen::Lower>().twistedBy(
        Eigen::PermutationMatrix<Eigen::Dynamic>(positions));
    Eigen::VectorXi parents = Eigen::VectorXi::Constant(lower.cols(), -1);
    Eigen::VectorXi last_rows = parents;
    Eigen::VectorXi counts = Eigen::VectorXi::Ones(lower.cols());
    // L has an entry in row k and column j if j is on the path in the elimination tree that leads
    // from an entry of row k of the matrix up to k.
    for (int k = 0; k < upper.cols(); ++k) {
        last_rows[k] = k;
        for (Eigen::SparseMatrix<double>::InnerIterator it(upper, k); it; ++it) {
            auto column = static_cast<int>(it.row());
            while (last_rows[column] != k) {
                last_rows[column] = k;
                ++counts[column];
                parents[column] = parents[column] < 0 ? k : parents[column];
                column = parents[column];
            }
        }
    }
    const Eigen::VectorXd numbers = counts.cast<double>();
    return {numbers.sum(), numbers.squaredNorm()};
}

Permutation inverse(const Permutation& order) {
    return Eigen::PermutationMatrix<Eigen::Dynamic>(order).transpose().eval().indices();
}

Permutation positions_of_rows(std::span<const SolverNode> nodes,
                              const Permutation& node_positions) {
    const Permutation order = inverse(node_positions);
    Permutation first_positions(order.size());
    int next = 0;
    for (const int node : order) {
        first_positions[node] =
            std::exchange(next, next + nodes[static_cast<std::size_t>(node)].rows);
    }
    Permutation positions(next);
    Eigen::Index row = 0;
    for (Eigen::Index node = 0; node < order.size(); ++node) {
        for (int k = 0; k < nodes[static_cast<std::size_t>(node)].rows; ++k) {
            positions[row++] = first_positions[node] + k;
        }
    }
    return positions;
}

}  // namespace foam::bench
