#pragma once

#include "core/sparse/front_plan.h"

#include <Eigen/Core>

#include <cstddef>

namespace foam {

/// Solves L D Lᵀ x = b in place, for float and double: forward substitution from the leaves to the
/// root, and backward substitution from the root to the leaves. `x` holds b on entry; its rows are
/// in the order of elimination. `factor` is what factor_fronts wrote. The bits do not depend on the
/// number of threads, which is at least 1.
template <class Real>
void solve_fronts(const FrontPlan& plan,
                  const Real* factor,
                  Eigen::Vector<Real, Eigen::Dynamic>& x,
                  std::size_t threads);

}  // namespace foam
