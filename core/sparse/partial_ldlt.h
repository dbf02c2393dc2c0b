// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/sparse/dense_kernels.h"

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>

namespace foam {

/// A view of a column-major matrix in memory of the caller, without gaps between the columns.
template <class Real>
using DenseView = Eigen::Map<Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>>;

/// Returns the size of the scratch memory of factor_panel and complete_update_matrix for one front,
/// in floating-point numbers. The front has `pivots` pivots and a border of `border` rows. The rows
/// of the border are the rows of the front's update matrix.
constexpr std::size_t ldlt_scratch(std::size_t pivots, std::size_t border) {
    const std::size_t group = kTileColumns;
    return kMaxDepth * ((std::max(pivots, border) + group - 1) / group * group);
}

/// Factors the first columns of a symmetric matrix as L D Lᵀ without pivoting. Instantiated for
/// float and double. The panel consists of all rows of these columns; its elements above the
/// diagonal are ignored. On return the panel holds D on its diagonal and the unit lower triangular
/// L below the diagonal. Elements above the diagonal are then undefined. `scratch` has room for
/// ldlt_scratch numbers. Returns false if a pivot is zero or not finite; the panel is then
/// undefined.
template <class Real>
bool factor_panel(DenseView<Real> panel, Real* scratch);

/// Subtracts the product L D Lᵀ over the columns of a factored panel from `update_matrix`. This
/// matrix holds the rows and columns that are not pivots. Only the lower triangle of the update
/// matrix is changed. `scratch` has room for ldlt_scratch numbers.
template <class Real>
void complete_update_matrix(const DenseView<Real>& panel,
                            DenseView<Real> update_matrix,
                            Real* scratch);

}  // namespace foam
