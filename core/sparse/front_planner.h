// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/sparse/dissection.h"
#include "core/sparse/front_plan.h"

#include <Eigen/SparseCore>

#include <cstddef>
#include <optional>
#include <span>

namespace foam {

/// Plans the factorization of matrices whose lower triangle has the given pattern, which is
/// compressed and has sorted columns. The nodes own the rows in order. Returns nothing if the
/// factor and the remainders of fronts would take more than `limit` floating-point numbers. The
/// plan is the same for any number of threads; `threads` as in thread_count.
std::optional<FrontPlan> plan_fronts(const Eigen::SparseMatrix<double>& lower_pattern,
                                     std::span<const SolverNode> nodes,
                                     const Domain& domain,
                                     const DissectionOptions& options,
                                     std::size_t limit,
                                     int threads = 1);

}  // namespace foam
