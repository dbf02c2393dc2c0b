// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/sparse/front_plan.h"

#include <cstddef>
#include <span>

namespace foam {

/// The memory that a numeric factorization reads and writes. Sizes are numbers of elements.
template <class Real>
struct FactorMemory {
    std::span<const double> values;  // entries in the order in which the sparse matrix stores them
    std::span<Real> factor;          // size: FrontPlan::panels_size
    std::span<Real> workspace;       // size: FrontPlan::workspace_size
    std::span<Real> scratch;         // size: FrontPlan::scratch_size per thread
};

/// Factors a matrix by the multifrontal method (Duff, Reid 1983). Instantiated for float and
/// double. Each front is assembled from its entries of the matrix and the update matrices of its
/// two children; then its pivots are eliminated. Returns false if a pivot is zero or not finite;
/// the factor is then undefined. The bits of the factor do not depend on the number of threads.
/// Precondition: 1 ≤ threads ≤ kMaxWorkers (front_workspace.h).
template <class Real>
bool factor_fronts(const FrontPlan& plan, const FactorMemory<Real>& memory, std::size_t threads);

}  // namespace foam
