// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/sparse/node_graph.h"

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <span>

namespace foam::bench {

/// An order of elimination: for each row, when it is eliminated.
using Turns = Eigen::VectorXi;

/// The size of L and the work of the factorization if rows are eliminated one by one, without any
/// zeros that a solver keeps for its own sake. It depends on the order of elimination alone.
struct Elimination {
    double numbers = 0.0;     // entries of L, including the diagonal
    double operations = 0.0;  // sum over the columns of L of the squared number of their entries
};

/// Counts the entries of each column of L by traversals of the elimination tree (Liu 1990).
Elimination count_elimination(const Eigen::SparseMatrix<double>& lower, const Turns& turns);

/// Returns the inverse of a permutation: the turns of an order, or the order of turns.
Turns inverse(const Turns& order);

/// Returns the turn of each row from the turn of each node. The nodes own the rows in turn.
Turns turns_of_rows(std::span<const SolverNode> nodes, const Turns& node_turns);

}  // namespace foam::bench
