#include "core/equilibrium/partial_ldlt.h"

#include <cmath>

namespace foam {

namespace {

using Eigen::Index;
using Window = Eigen::Map<Eigen::MatrixXd, 0, Eigen::OuterStride<>>;

constexpr Index kNarrow = 16;  // so many columns are factored one after the other

Window window(DenseView& matrix, Index row, Index begin, Index end) {
    return {matrix.data() + begin * matrix.rows() + row,
            matrix.rows() - row,
            end - begin,
            Eigen::OuterStride<>(matrix.rows())};
}

// target -= L D Lᵀ over the factored columns begin to end, lower trapezoid. The target's rows are
// those of the panel from first_row on, its columns are as many of these as it has.
void subtract_share(
    const DenseView& panel, Index begin, Index end, Window target, double* scratch) {
    const Index cols = target.cols();
    const Index below = target.rows() - cols;
    for (Index k = begin; k < end; k += kLargestDepth) {
        const Index depth = std::min(kLargestDepth, end - k);
        const auto factor = panel.block(panel.rows() - target.rows(), k, target.rows(), depth);
        DenseView scaled(scratch, cols, depth);
        scaled = factor.topRows(cols) * panel.diagonal().segment(k, depth).asDiagonal();
        target.topRows(cols).triangularView<Eigen::Lower>() -=
            factor.topRows(cols) * scaled.transpose();
        if (below > 0) {
            target.bottomRows(below).noalias() -= factor.bottomRows(below) * scaled.transpose();
        }
    }
}

// Columns begin to end, out of which all earlier columns' shares have been taken.
bool factor_columns(DenseView& panel, Index begin, Index end) {
    for (Index j = begin; j < end; ++j) {
        const double pivot = panel(j, j);
        if (pivot == 0.0 || !std::isfinite(pivot)) {
            return false;
        }
        const double inverse = 1.0 / pivot;
        for (Index k = j + 1; k < end; ++k) {
            const Index rows = panel.rows() - k;
            panel.col(k).tail(rows) -= panel(k, j) * inverse * panel.col(j).tail(rows);
        }
        panel.col(j).tail(panel.rows() - j - 1) *= inverse;
    }
    return true;
}

// As factor_columns; halves the range, so that most of the work is in large products.
bool factor_range(DenseView& panel, Index begin, Index end, double* scratch) {
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

bool factor_panel(DenseView panel, double* scratch) {
    return factor_range(panel, 0, panel.cols(), scratch);
}

void update_remainder(const DenseView& panel, DenseView remainder, double* scratch) {
    if (remainder.cols() > 0) {
        subtract_share(panel, 0, panel.cols(), window(remainder, 0, 0, remainder.cols()), scratch);
    }
}

}  // namespace foam
