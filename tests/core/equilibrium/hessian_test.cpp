// SPDX-License-Identifier: Apache-2.0

#include "core/equilibrium/hessian.h"

#include "core/equilibrium/residual.h"
#include "core/foam/honeycomb.h"
#include "core/foam/measure.h"
#include "core/network/t2.h"
#include "tests/core/equilibrium/derivative_foams.h"
#include "tests/core/foams.h"
#include "tests/support/sample_foams.h"

#include <gtest/gtest.h>

#include <vector>

namespace foam {
namespace {

using test::derivative_foams;
using test::full_hessian;
using test::shifted;

// The steps of the central differences are 1e-6. Rounding errors are 1e-15 / 1e-6. The cubic term
// is 1e-12 / 6 times third derivatives of the forces. These are of the order of T / c³ and reach
// 1e4; close to the limit of the half angle they are hundreds of times larger.
TEST(Hessian, IsTheCentralDifferenceOfTheResidualByEachUnknown) {
    constexpr double kStep = 1e-6;
    std::vector<Foam> foams = derivative_foams();
    const std::vector<Foam> patches = test::derivative_patches();
    foams.insert(foams.end(), patches.begin(), patches.end());
    for (const Foam& foam : foams) {
        const Unknowns unknowns = all_unknowns(foam.network);
        const Eigen::MatrixXd h = full_hessian(foam, unknowns);
        ASSERT_EQ(h.rows(), unknowns.size());
        for (int column = 0; column < unknowns.size(); ++column) {
            const Eigen::VectorXd difference =
                (residual(shifted(foam, unknowns, column, kStep), unknowns) -
                 residual(shifted(foam, unknowns, column, -kStep), unknowns)) /
                (2.0 * kStep);
            EXPECT_LT((h.col(column) - difference).norm(), 1e-6 * (1.0 + difference.norm()))
                << "column " << column << " of " << foam.network.bubble_count() << " bubbles";
        }
    }
}

TEST(Hessian, ReachesFilmsAtTheLimit) {
    int at_limit = 0;
    for (const Foam& foam : derivative_foams()) {
        at_limit += equilibrium_errors(foam).films_at_limit;
    }
    EXPECT_GT(at_limit, 10);
}

TEST(Hessian, HoldsTheLowerTriangleOnly) {
    const Foam foam = test::bent_foam(12, 0.5, 1);
    const Unknowns unknowns = all_unknowns(foam.network);
    const Hessian hessian(foam.network, unknowns);
    for (int column = 0; column < hessian.matrix().outerSize(); ++column) {
        for (Eigen::SparseMatrix<double>::InnerIterator entry(hessian.matrix(), column); entry;
             ++entry) {
            EXPECT_GE(entry.row(), column);
        }
    }
}

TEST(Hessian, EvaluatesAfreshEachTime) {
    const Foam foam = test::bent_foam(12, 0.5, 1);
    const Foam other = shifted(foam, all_unknowns(foam.network), 3, 0.01);
    const Unknowns unknowns = all_unknowns(foam.network);
    Hessian hessian(foam.network, unknowns);
    const Eigen::MatrixXd first = hessian.evaluate(foam);
    const Eigen::MatrixXd second = hessian.evaluate(other);
    const Eigen::MatrixXd third = hessian.evaluate(foam);
    EXPECT_NE(first, second);
    EXPECT_EQ(first, third);
    EXPECT_EQ(Eigen::MatrixXd(hessian.matrix()), third);
}

// On a torus, a translation and a common change of all pressures do not change the residual.
TEST(Hessian, HasTheNullModesOfTheTorus) {
    for (const Foam& foam : derivative_foams()) {
        const Unknowns unknowns = all_unknowns(foam.network);
        const Eigen::MatrixXd h = full_hessian(foam, unknowns);
        Eigen::VectorXd along_x = Eigen::VectorXd::Zero(h.rows());
        Eigen::VectorXd common = Eigen::VectorXd::Zero(h.rows());
        for (const JunctionId junction : unknowns.junctions) {
            along_x[unknowns.position_row(junction)] = 1.0;
        }
        common.tail(static_cast<Eigen::Index>(unknowns.bubbles.size())).setOnes();
        const double size = h.cwiseAbs().maxCoeff();
        EXPECT_LT((h * along_x).norm(), 1e-13 * size);
        EXPECT_LT((h * common).norm(), 1e-13 * size);
    }
}

// In the plane, a translation does not change the residual. A rotation rotates the residual, so
// that it is a null mode only if the residual is zero. A common change of all pressures inflates
// the patch.
TEST(Hessian, HasTheNullModesOfThePlane) {
    for (const Foam& foam : test::derivative_patches()) {
        const Unknowns unknowns = all_unknowns(foam.network);
        const Eigen::MatrixXd h = full_hessian(foam, unknowns);
        const Eigen::VectorXd r = residual(foam, unknowns);
        Eigen::VectorXd along_x = Eigen::VectorXd::Zero(h.rows());
        Eigen::VectorXd rotation = Eigen::VectorXd::Zero(h.rows());
        Eigen::VectorXd turned = Eigen::VectorXd::Zero(h.rows());
        for (const JunctionId junction : unknowns.junctions) {
            const int row = unknowns.position_row(junction);
            along_x[row] = 1.0;
            rotation.segment<2>(row) = turned_left(foam.positions[junction]);
            turned.segment<2>(row) = turned_left(r.segment<2>(row));
        }
        const double size = h.cwiseAbs().maxCoeff();
        EXPECT_LT((h * along_x).norm(), 1e-13 * size);
        EXPECT_LT((h * rotation - turned).norm(), 1e-12 * size);
        Eigen::VectorXd common = Eigen::VectorXd::Zero(h.rows());
        common.segment(unknowns.first_pressure_row(), static_cast<int>(unknowns.bubbles.size()))
            .setOnes();
        EXPECT_GT((h * common).norm(), 0.1);
    }
}

TEST(Hessian, LeavesTheDeadOut) {
    Foam sparse = test::honeycomb_around(3);
    vanish(sparse.network, BubbleId{5});
    Foam dense = sparse;
    compact(dense);
    EXPECT_EQ(full_hessian(sparse, all_unknowns(sparse.network)),
              full_hessian(dense, all_unknowns(dense.network)));
}

}  // namespace
}  // namespace foam
