#pragma once

#include "core/sparse/dense_kernels.h"

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>

namespace foam {

/// A column-major matrix in borrowed memory, its columns without gaps.
template <class Real>
using DenseView = Eigen::Map<Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>>;

// All that follows is there for float and double.

/// Numbers of scratch memory that the functions below need.
constexpr std::size_t ldlt_scratch(std::size_t pivots, std::size_t border) {
    const std::size_t group = kGroup;
    return kLargestDepth * ((std::max(pivots, border) + group - 1) / group * group);
}

/// Factors the first columns of a symmetric matrix as L D Lᵀ, without pivoting. The panel holds
/// these columns, lower part, all rows; afterwards D on the diagonal and L, whose diagonal is 1,
/// below. What is above the diagonal is without meaning and may be overwritten.
/// False where a pivot is zero or not finite: the panel is then spoilt.
template <class Real>
bool factor_panel(DenseView<Real> panel, Real* scratch);

/// Takes the share of the factored columns out of the rest of the matrix, lower triangle.
template <class Real>
void update_remainder(const DenseView<Real>& panel, DenseView<Real> remainder, Real* scratch);

}  // namespace foam
