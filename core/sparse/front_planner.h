// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/sparse/dissection.h"
#include "core/sparse/front_plan.h"

#include <Eigen/SparseCore>

#include <cstddef>
#include <optional>
#include <span>

namespace foam {

/// Plans the factorization of matrices whose lower triangle has the given pattern. Rows are
/// eliminated in the order of `dissection`. A node stands for consecutive rows of the matrix:
/// nodes[0] for the first rows, nodes[1] for the next ones, and so on. Returns std::nullopt if the
/// factor and the update matrices of fronts would take more than `limit` floating-point numbers.
/// Preconditions: the pattern is compressed, and the entries of each column are sorted by row;
/// `graph` is the graph of the pattern (node_graph), and `dissection` is a dissection of this
/// graph.
std::optional<FrontPlan> plan_fronts(const Eigen::SparseMatrix<double>& lower_pattern,
                                     std::span<const SolverNode> nodes,
                                     const NodeGraph& graph,
                                     const Dissection& dissection,
                                     std::size_t limit);

}  // namespace foam
