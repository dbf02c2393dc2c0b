// SPDX-License-Identifier: Apache-2.0

#include "core/sparse/partial_ldlt.h"

#include "core/sparse/dense_kernels.h"

#include <cmath>

namespace foam {

// The factorization is recursive and blocked. The left half of the columns is factored. Then the
// product L D Lᵀ over this half is subtracted from the right half, and the right half is factored.
// Ranges of at most kMaxDirectColumns columns are factored directly. Thus most of the work is in
// large matrix products (dense_kernels.h). The two factors of a product are L and L D, of which L D
// is packed (DenseProduct::right).

namespace {

using Eigen::Index;

template <class Real>
using Window =
    Eigen::Map<Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>, 0, Eigen::OuterStride<>>;

// Returns a view of the rows from `row` on and the columns [begin, end) of a matrix.
template <class Real>
Window<Real> window(DenseView<Real>& matrix, Index row, Index begin, Index end) {
    return {matrix.data() + begin * matrix.rows() + row,
            matrix.rows() - row,
            end - begin,
            Eigen::OuterStride<>(matrix.rows())};
}

// Stores L D in `packed`, in the layout of DenseProduct::right, for the given number of rows from
// `first_row` on and the columns [begin, begin + depth).
template <class Real>
void pack_scaled(const DenseView<Real>& panel,
                 Index first_row,
                 Index rows,
                 Index begin,
                 Index depth,
                 Real* packed) {
    for (Index group = 0; group < rows; group += kTileColumns) {
        const Index width = std::min<Index>(kTileColumns, rows - group);
        for (Index k = begin; k < begin + depth; ++k) {
            const Real* column = &panel.coeffRef(first_row + group, k);
            const Real pivot = panel.coeffRef(k, k);
            for (Index row = 0; row < kTileColumns; ++row) {
                *packed++ = row < width ? column[row] * pivot : Real(0);
            }
        }
    }
}

// Subtracts L D Lᵀ over the factored columns [begin, end) from the target, on and below the
// target's diagonal. The rows of the target correspond to the last rows of the panel. The columns
// of the target correspond to the first of these rows.
template <class Real>
void subtract_ldlt(
    const DenseView<Real>& panel, Index begin, Index end, Window<Real> target, Real* scratch) {
    const Index first_row = panel.rows() - target.rows();
    for (Index k = begin; k < end; k += kMaxDepth) {
        const Index depth = std::min(kMaxDepth, end - k);
        pack_scaled(panel, first_row, target.cols(), k, depth, scratch);
        subtract_product<Real>({.rows = target.rows(),
                                .cols = target.cols(),
                                .depth = depth,
                                .left = panel.data() + k * panel.rows() + first_row,
                                .left_stride = panel.rows(),
                                .right = scratch,
                                .target = target.data(),
                                .target_stride = target.outerStride()});
    }
}

// Factors the rows [begin, end) of the columns [begin, end) of the panel. Precondition: the
// products over all earlier columns have been subtracted. Returns false if a pivot is zero or not
// finite.
template <class Real>
bool factor_triangle(DenseView<Real>& panel, Index begin, Index end) {
    for (Index j = begin; j < end; ++j) {
        const Real pivot = panel(j, j);
        if (pivot == Real(0) || !std::isfinite(pivot)) {
            return false;
        }
        const Real inverse = Real(1) / pivot;
        for (Index k = j + 1; k < end; ++k) {
            const Real scaled = panel(k, j) * inverse;
            for (Index row = k; row < end; ++row) {
                panel(row, k) -= scaled * panel(row, j);
            }
        }
        for (Index row = j + 1; row < end; ++row) {
            panel(row, j) *= inverse;
        }
    }
    return true;
}

// Factors the columns [begin, end) of the panel in all rows from `begin` on. Precondition: the
// products over all earlier columns have been subtracted. Returns false if a pivot is zero or not
// finite.
template <class Real>
bool factor_columns(DenseView<Real>& panel, Index begin, Index end) {
    if (!factor_triangle(panel, begin, end)) {
        return false;
    }
    Real* const corner = panel.data() + begin * panel.rows() + begin;
    eliminate<Real>({.rows = panel.rows() - end,
                     .pivots = end - begin,
                     .triangle = corner,
                     .target = corner + (end - begin),
                     .stride = panel.rows()});
    return true;
}

// Factors the columns [begin, end) like factor_columns, but recursively by halves, so that most of
// the work is in large products.
template <class Real>
bool factor_range(DenseView<Real>& panel, Index begin, Index end, Real* scratch) {
    if (end - begin <= kMaxDirectColumns) {
        return factor_columns(panel, begin, end);
    }
    const Index middle =
        begin + ((end - begin) / 2 + kMaxDirectColumns - 1) / kMaxDirectColumns * kMaxDirectColumns;
    if (!factor_range(panel, begin, middle, scratch)) {
        return false;
    }
    subtract_ldlt(panel, begin, middle, window(panel, middle, middle, end), scratch);
    return factor_range(panel, middle, end, scratch);
}

}  // namespace

template <class Real>
bool factor_panel(DenseView<Real> panel, Real* scratch) {
    return factor_range(panel, 0, panel.cols(), scratch);
}

template <class Real>
void complete_update_matrix(const DenseView<Real>& panel,
                            DenseView<Real> update_matrix,
                            Real* scratch) {
    if (update_matrix.cols() > 0) {
        subtract_ldlt(
            panel, 0, panel.cols(), window(update_matrix, 0, 0, update_matrix.cols()), scratch);
    }
}

template bool factor_panel(DenseView<float>, float*);
template bool factor_panel(DenseView<double>, double*);
template void complete_update_matrix(const DenseView<float>&, DenseView<float>, float*);
template void complete_update_matrix(const DenseView<double>&, DenseView<double>, double*);

}  // namespace foam
