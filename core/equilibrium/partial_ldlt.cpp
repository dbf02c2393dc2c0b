#include "core/equilibrium/partial_ldlt.h"

#include <cmath>

namespace foam {

namespace {

using Eigen::Index;

template <class Real>
using Window =
    Eigen::Map<Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>, 0, Eigen::OuterStride<>>;

constexpr Index kNarrow = 16;  // so many columns are factored one after the other

template <class Real>
Window<Real> window(DenseView<Real>& matrix, Index row, Index begin, Index end) {
    return {matrix.data() + begin * matrix.rows() + row,
            matrix.rows() - row,
            end - begin,
            Eigen::OuterStride<>(matrix.rows())};
}

// target -= L D Lᵀ over the factored columns begin to end, lower trapezoid. The target's rows are
// those of the panel from first_row on, its columns are as many of these as it has.
template <class Real>
void subtract_share(
    const DenseView<Real>& panel, Index begin, Index end, Window<Real> target, Real* scratch) {
    const Index cols = target.cols();
    const Index below = target.rows() - cols;
    for (Index k = begin; k < end; k += kLargestDepth) {
        const Index depth = std::min(kLargestDepth, end - k);
        const auto factor = panel.block(panel.rows() - target.rows(), k, target.rows(), depth);
        DenseView<Real> scaled(scratch, cols, depth);
        scaled = factor.topRows(cols) * panel.diagonal().segment(k, depth).asDiagonal();
        target.topRows(cols).template triangularView<Eigen::Lower>() -=
            factor.topRows(cols) * scaled.transpose();
        if (below > 0) {
            target.bottomRows(below).noalias() -= factor.bottomRows(below) * scaled.transpose();
        }
    }
}

// Columns begin to end, out of which all earlier columns' shares have been taken.
template <class Real>
bool factor_columns(DenseView<Real>& panel, Index begin, Index end) {
    for (Index j = begin; j < end; ++j) {
        const Real pivot = panel(j, j);
        if (pivot == Real(0) || !std::isfinite(pivot)) {
            return false;
        }
        const Real inverse = Real(1) / pivot;
        for (Index k = j + 1; k < end; ++k) {
            const Index rows = panel.rows() - k;
            panel.col(k).tail(rows) -= panel(k, j) * inverse * panel.col(j).tail(rows);
        }
        panel.col(j).tail(panel.rows() - j - 1) *= inverse;
    }
    return true;
}

// As factor_columns; halves the range, so that most of the work is in large products.
template <class Real>
bool factor_range(DenseView<Real>& panel, Index begin, Index end, Real* scratch) {
    if (end - begin <= kNarrow) {
        return factor_columns(panel, begin, end);
    }
    const Index middle = begin + ((end - begin) / 2 + kNarrow - 1) / kNarrow * kNarrow;
    if (!factor_range(panel, begin, middle, scratch)) {
        return false;
    }
    subtract_share(panel, begin, middle, window(panel, middle, middle, end), scratch);
    return factor_range(panel, middle, end, scratch);
}

}  // namespace

template <class Real>
bool factor_panel(DenseView<Real> panel, Real* scratch) {
    return factor_range(panel, 0, panel.cols(), scratch);
}

template <class Real>
void update_remainder(const DenseView<Real>& panel, DenseView<Real> remainder, Real* scratch) {
    if (remainder.cols() > 0) {
        subtract_share(panel, 0, panel.cols(), window(remainder, 0, 0, remainder.cols()), scratch);
    }
}

template bool factor_panel(DenseView<float>, float*);
template bool factor_panel(DenseView<double>, double*);
template void update_remainder(const DenseView<float>&, DenseView<float>, float*);
template void update_remainder(const DenseView<double>&, DenseView<double>, double*);

}  // namespace foam
