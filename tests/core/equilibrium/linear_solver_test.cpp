// SPDX-License-Identifier: Apache-2.0

#include "core/equilibrium/linear_solver.h"

#include "core/dynamics/collapse.h"
#include "core/equilibrium/hessian.h"
#include "core/foam/honeycomb.h"
#include "core/foam/t1_rule.h"
#include "tests/core/foams.h"
#include "tests/support/sample_foams.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <set>
#include <vector>

namespace foam {
namespace {

// Returns the Hessian with a regularized diagonal, which removes the null modes as in Newton's
// method.
Eigen::SparseMatrix<double> regular_hessian(const Foam& foam, const Unknowns& unknowns) {
    Hessian hessian(foam.network, unknowns);
    Eigen::SparseMatrix<double> matrix = hessian.evaluate(foam);
    const auto positions = static_cast<Eigen::Index>(2 * unknowns.junctions.size());
    for (Eigen::Index row = 0; row < matrix.rows(); ++row) {
        matrix.coeffRef(row, row) += row < positions ? 1e-3 : -1e-3;
    }
    return matrix;
}

TEST(LinearSolver, SolvesWithTheHessian) {
    for (const int bubbles : {2, 5, 40, 400}) {
        const Foam foam = test::bent_foam(bubbles, 0.2, 6);
        const Unknowns unknowns = all_unknowns(foam.network);
        const Eigen::SparseMatrix<double> matrix = regular_hessian(foam, unknowns);
        const Eigen::VectorXd expected = Eigen::VectorXd::LinSpaced(matrix.rows(), -1.0, 2.0);
        const Eigen::VectorXd right = matrix.selfadjointView<Eigen::Lower>() * expected;
        for (const Precision precision : {Precision::Double, Precision::Single}) {
            LinearSolver solver;
            solver.start(foam, unknowns, precision);
            ASSERT_TRUE(solver.factor(matrix));
            const Eigen::VectorXd back =
                matrix.selfadjointView<Eigen::Lower>() * solver.solve(right);
            EXPECT_LT((back - right).norm(),
                      (precision == Precision::Double ? 1e-9 : 1e-2) * right.norm());
        }
    }
}

std::set<std::uint64_t> names_of(const std::vector<SolverNode>& nodes) {
    std::set<std::uint64_t> names;
    for (const SolverNode& node : nodes) {
        names.insert(node.name);
    }
    return names;
}

// Returns how many of the nodes have the name of one of the others.
int common_names(const std::vector<SolverNode>& nodes, const std::vector<SolverNode>& others) {
    const std::set<std::uint64_t> names = names_of(others);
    return static_cast<int>(std::ranges::count_if(
        nodes, [&](const SolverNode& node) { return names.contains(node.name); }));
}

std::vector<SolverNode> nodes_of(const Foam& foam) {
    return solver_nodes(foam, all_unknowns(foam.network));
}

TEST(LinearSolver, NodesKeepTheirNamesWhenABubbleVanishes) {
    for (Foam foam : {test::equilibrated_foam(100, 2), test::patch_foam(100, 2)}) {
        const std::vector<SolverNode> before = nodes_of(foam);
        EXPECT_EQ(names_of(before).size(), before.size());
        TopologyCounts counts;
        ASSERT_TRUE(collapse(foam, BubbleId{20}, counts));
        compact(foam);
        const std::vector<SolverNode> after = nodes_of(foam);
        EXPECT_LT(after.size(), before.size());
        // Each T1 renames two junctions, and the T2 one. No outer film is near.
        EXPECT_GE(common_names(after, before), static_cast<int>(after.size()) - 2 * counts.t1 - 1);
        EXPECT_EQ(names_of(after).size(), after.size());
    }
}

TEST(LinearSolver, AT1RenamesTwoJunctions) {
    Foam foam = test::equilibrated_foam(100, 2);
    const std::vector<SolverNode> before = nodes_of(foam);
    flip_film(foam, FilmId{40});
    EXPECT_EQ(common_names(nodes_of(foam), before), static_cast<int>(before.size()) - 2);
}

// Half of the positions are not numbers, so that the order of elimination must come from the graph
// alone. A foam of 2,000 bubbles has 10,000 rows. If these positions were used, the factor would be
// dense and take 200 MB, more than the limit.
TEST(LinearSolver, NeedsNoPositions) {
    Foam foam = test::bent_foam(2000, 0.2, 6);
    const Unknowns unknowns = all_unknowns(foam.network);
    const Eigen::SparseMatrix<double> matrix = regular_hessian(foam, unknowns);
    for (std::size_t junction = 0; junction < foam.positions.size(); junction += 2) {
        foam.positions[JunctionId{static_cast<std::uint32_t>(junction)}].setConstant(
            std::numeric_limits<double>::quiet_NaN());
    }
    LinearSolver solver;
    solver.start(foam, unknowns, Precision::Double);
    ASSERT_TRUE(solver.factor(matrix));
    const Eigen::VectorXd right = Eigen::VectorXd::Ones(unknowns.size());
    const Eigen::VectorXd back = matrix.selfadjointView<Eigen::Lower>() * solver.solve(right);
    EXPECT_LT((back - right).norm(), 1e-9 * right.norm());
}

TEST(LinearSolver, StaysValidWhileTheFoamMoves) {
    const Foam foam = test::bent_foam(100, 0.2, 6);
    Foam moved = foam;
    for (double& pressure : moved.pressures) {
        pressure *= 0.5;
    }
    const Unknowns unknowns = all_unknowns(foam.network);
    LinearSolver used;
    used.start(foam, unknowns, Precision::Single);
    ASSERT_TRUE(used.factor(regular_hessian(foam, unknowns)));
    ASSERT_TRUE(used.factor(regular_hessian(moved, unknowns)));
    LinearSolver fresh;
    fresh.start(foam, unknowns, Precision::Single);
    ASSERT_TRUE(fresh.factor(regular_hessian(moved, unknowns)));
    const Eigen::VectorXd right = Eigen::VectorXd::Ones(unknowns.size());
    EXPECT_EQ(used.solve(right), fresh.solve(right));
}

TEST(LinearSolver, GivesTheSameBitsOnAnyNumberOfThreads) {
    const Foam foam = test::bent_foam(1000, 0.2, 6);
    const Unknowns unknowns = all_unknowns(foam.network);
    const Eigen::SparseMatrix<double> matrix = regular_hessian(foam, unknowns);
    const Eigen::VectorXd right = Eigen::VectorXd::Ones(unknowns.size());
    LinearSolver one;
    one.start(foam, unknowns, Precision::Single, 1);
    ASSERT_TRUE(one.factor(matrix));
    const Eigen::VectorXd expected = one.solve(right);
    for (const int threads : {2, 3, 8}) {
        LinearSolver several;
        several.start(foam, unknowns, Precision::Single, threads);
        ASSERT_TRUE(several.factor(matrix));
        EXPECT_EQ(several.solve(right), expected) << threads;
    }
}

// Each junction has a node of two rows, at its position. Each bubble has a node of one row, at its
// middle. All positions are in the torus' own cell.
TEST(LinearSolver, NodesHaveThePositionsOfTheUnknowns) {
    const Foam foam = honeycomb(4, 4);
    const Unknowns unknowns = all_unknowns(foam.network);
    const std::vector<SolverNode> nodes = solver_nodes(foam, unknowns);
    ASSERT_EQ(nodes.size(), 32U + 16U);
    for (std::size_t k = 0; k < nodes.size(); ++k) {
        EXPECT_EQ(nodes[k].rows, k < 32 ? 2 : 1);
        EXPECT_TRUE(foam.domain.cell_of(nodes[k].position) == (LatticeOffset{0, 0}));
    }
    EXPECT_EQ(nodes[7].position, foam.positions[JunctionId{7}]);
    // Bubble 5 is the second bubble of the second row from below. Its middle is at (2 w, 2.5 a),
    // where a is the length of a film and w = sqrt(3) a the width of a bubble.
    const Vec2 middle(foam.domain.width * 2.0 / 4.0, foam.domain.height * 2.5 / 6.0);
    EXPECT_LT((nodes[32 + 5].position - middle).norm(), 1e-14);
}

}  // namespace
}  // namespace foam
