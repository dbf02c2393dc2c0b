// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/sparse/front_plan.h"

#include <Eigen/Core>

#include <cstddef>

namespace foam {

/// Solves L D Lᵀ x = b in place. Forward substitution proceeds from the leaves of the tree of
/// fronts to its root, then backward substitution proceeds from the root to the leaves. On entry
/// `x` holds b, on return the solution. The rows of `x` are in the order of elimination. `factor`
/// is the output of factor_fronts. Instantiated for float and double. The bits of the result do not
/// depend on the number of threads. Precondition: threads ≥ 1.
template <class Real>
void solve_fronts(const FrontPlan& plan,
                  const Real* factor,
                  Eigen::Vector<Real, Eigen::Dynamic>& x,
                  std::size_t threads);

}  // namespace foam
