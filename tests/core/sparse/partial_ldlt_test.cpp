// SPDX-License-Identifier: Apache-2.0

#include "core/sparse/partial_ldlt.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace foam {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

// Returns a symmetric matrix, of which the first third is positive definite and the rest is
// negative definite.
MatrixXd quasi_definite(Index size) {
    std::srand(7);  // NOLINT(cert-msc51-cpp): Eigen's Random draws from it
    MatrixXd matrix = MatrixXd::Random(size, size);
    matrix = (matrix + matrix.transpose()).eval();
    const Index positive = size / 3;
    const auto diagonal = static_cast<double>(2 * size);
    matrix.diagonal().head(positive).array() += diagonal;
    matrix.diagonal().tail(size - positive).array() -= diagonal;
    return matrix;
}

struct Partial {
    MatrixXd panel;
    MatrixXd update_matrix;
    bool succeeded = false;
};

// Eliminates the first columns of a matrix. Elements above the diagonal are NaN on entry, because
// they must not be used.
Partial eliminate(const MatrixXd& matrix, Index pivots) {
    MatrixXd lower = matrix.triangularView<Eigen::Lower>();
    lower.triangularView<Eigen::StrictlyUpper>().setConstant(
        std::numeric_limits<double>::quiet_NaN());
    const Index border = matrix.rows() - pivots;
    Partial result{lower.leftCols(pivots), lower.bottomRightCorner(border, border)};
    std::vector<double> scratch(
        ldlt_scratch(static_cast<std::size_t>(pivots), static_cast<std::size_t>(border)));
    const DenseView<double> panel(result.panel.data(), matrix.rows(), pivots);
    const DenseView<double> update_matrix(result.update_matrix.data(), border, border);
    result.succeeded = factor_panel(panel, scratch.data());
    complete_update_matrix(panel, update_matrix, scratch.data());
    return result;
}

void expect_eliminated(const MatrixXd& matrix, Index pivots) {
    SCOPED_TRACE(testing::Message() << matrix.rows() << " rows, " << pivots << " pivots");
    const Partial partial = eliminate(matrix, pivots);
    ASSERT_TRUE(partial.succeeded);
    MatrixXd L = MatrixXd::Identity(matrix.rows(), matrix.rows());
    L.leftCols(pivots).triangularView<Eigen::StrictlyLower>() = partial.panel;
    MatrixXd D = MatrixXd::Zero(matrix.rows(), matrix.rows());
    D.diagonal().head(pivots) = partial.panel.diagonal();
    const Index border = matrix.rows() - pivots;
    D.bottomRightCorner(border, border) = partial.update_matrix.selfadjointView<Eigen::Lower>();
    const double error = (L * D * L.transpose() - matrix).cwiseAbs().maxCoeff();
    EXPECT_LT(error, 1e-14 * static_cast<double>(matrix.rows()) * matrix.cwiseAbs().maxCoeff());
}

// 300 pivots are more than kMaxDepth holds twice.
TEST(PartialLdlt, GivesBackTheMatrix) {
    for (const Index pivots : {0, 1, 2, 15, 16, 17, 33, 100, 300}) {
        for (const Index border : {0, 1, 7, 60}) {
            if (pivots + border > 0) {
                expect_eliminated(quasi_definite(pivots + border), pivots);
            }
        }
    }
}

TEST(PartialLdlt, ReportsAPivotOfZero) {
    for (const Index zero : {0, 5, 20, 39}) {
        MatrixXd matrix = quasi_definite(50);
        matrix.row(zero).setZero();
        matrix.col(zero).setZero();
        EXPECT_FALSE(eliminate(matrix, 40).succeeded) << zero;
    }
}

TEST(PartialLdlt, ReportsAPivotThatIsNotFinite) {
    for (const double bad :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        MatrixXd matrix = quasi_definite(50);
        matrix(30, 30) = bad;
        EXPECT_FALSE(eliminate(matrix, 40).succeeded);
    }
}

}  // namespace
}  // namespace foam
