// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/sparse/dense_kernels.h"

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>

namespace foam {

/// A column-major matrix in memory of the caller. Its columns are adjacent.
template <class Real>
using DenseView = Eigen::Map<Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>>;

/// Returns the size of the scratch memory of factor_panel and update_remainder, in floating-point
/// numbers.
constexpr std::size_t ldlt_scratch(std::size_t pivots, std::size_t border) {
    const std::size_t group = kGroup;
    return kLargestDepth * ((std::max(pivots, border) + group - 1) / group * group);
}

/// Factors the first columns of a symmetric matrix as L D Lᵀ without pivoting, for float and
/// double. The panel consists of all rows of these columns; only its lower part is read. Afterwards
/// the panel has D on its diagonal and the unit lower triangular L below it. Elements above the
/// diagonal are then undefined. Returns false if a pivot is zero or not finite; the panel is then
/// undefined.
template <class Real>
bool factor_panel(DenseView<Real> panel, Real* scratch);

/// Subtracts the product L D Lᵀ of the factored columns from the remaining rows and columns of the
/// matrix, `remainder`. Only the lower triangle of the remainder is computed.
template <class Real>
void update_remainder(const DenseView<Real>& panel, DenseView<Real> remainder, Real* scratch);

}  // namespace foam
