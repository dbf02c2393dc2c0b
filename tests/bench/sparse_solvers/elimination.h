// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/sparse/node_graph.h"

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <span>

namespace foam::bench {

/// The position of each row in the order of elimination.
using Permutation = Eigen::VectorXi;

/// The size of L and the work of the factorization if rows are eliminated one by one. The explicit
/// zeros that some solvers store do not count. Both numbers depend only on the pattern and on the
/// order of elimination.
struct Elimination {
    double numbers = 0.0;     // entries of L, including the diagonal
    double operations = 0.0;  // sum over the columns of L of the squared number of their entries
};

/// Counts the entries of each column of L by traversals of the elimination tree (Liu 1990).
Elimination count_elimination(const Eigen::SparseMatrix<double>& lower,
                              const Permutation& positions);

/// Returns the inverse of a permutation: the positions for an order of elimination, or the order
/// for positions.
Permutation inverse(const Permutation& order);

/// Returns the position of each row from the position of each node. Each node has consecutive rows,
/// in the order of the nodes.
Permutation positions_of_rows(std::span<const SolverNode> nodes, const Permutation& node_positions);

}  // namespace foam::bench
