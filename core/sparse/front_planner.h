// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/sparse/dissection.h"
#include "core/sparse/front_plan.h"

#include <Eigen/SparseCore>

#include <cstddef>
#include <optional>
#include <span>

namespace foam {

/// Plans the factorization of matrices whose lower triangle has the given pattern. The first node
/// has the first rows of the matrix, the second node has the next rows, and so on. Returns
/// std::nullopt if the factor and the update matrices of fronts would take more than `limit`
/// floating-point numbers. The plan is the same for any number of threads. `threads` has the same
/// meaning as in thread_count. Precondition: the pattern is compressed, and the entries of each
/// column are sorted by row.
std::optional<FrontPlan> plan_fronts(const Eigen::SparseMatrix<double>& lower_pattern,
                                     std::span<const SolverNode> nodes,
                                     const Domain& domain,
                                     const DissectionOptions& options,
                                     std::size_t limit,
                                     int threads = 1);

/// Plans the factorization in the order of a given dissection of the graph of the matrix
/// (node_graph). Preconditions and result as above.
std::optional<FrontPlan> plan_fronts(const Eigen::SparseMatrix<double>& lower_pattern,
                                     std::span<const SolverNode> nodes,
                                     const NodeGraph& graph,
                                     const Dissection& dissection,
                                     std::size_t limit);

}  // namespace foam
