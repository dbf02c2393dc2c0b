// SPDX-License-Identifier: Apache-2.0

#include "core/sparse/sparse_ldlt.h"

#include "core/dynamics/collapse.h"
#include "core/equilibrium/hessian.h"
#include "core/equilibrium/linear_solver.h"
#include "core/equilibrium/relaxation.h"
#include "core/foam/honeycomb.h"
#include "core/foam/seeding.h"
#include "core/foam/t1_rule.h"
#include "core/network/t1.h"
#include "core/parallel/parallel_for.h"
#include "tests/support/sample_foams.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace foam {
namespace {

using SparseMatrix = Eigen::SparseMatrix<double>;

struct System {
    Domain domain;
    std::vector<SolverNode> nodes;
    SparseMatrix matrix;  // lower triangle
    Eigen::VectorXd right_hand_side;
};

// Returns the system of the Hessian without null modes: `shift` is added to the diagonal in rows of
// positions and subtracted in rows of pressures.
System system_of(const Foam& foam, double shift) {
    const Unknowns unknowns = all_unknowns(foam.network);
    Hessian hessian(foam.network, unknowns);
    const auto positions = static_cast<Eigen::Index>(2 * unknowns.junctions.size());
    System system{foam.domain, solver_nodes(foam, unknowns), hessian.evaluate(foam), {}};
    for (Eigen::Index row = 0; row < system.matrix.rows(); ++row) {
        system.matrix.coeffRef(row, row) += row < positions ? shift : -shift;
    }
    system.right_hand_side = Eigen::VectorXd::LinSpaced(system.matrix.rows(), -1.0, 2.0);
    return system;
}

Foam relaxed_foam(int bubbles, double aspect = 1.0, std::uint64_t seed = 1) {
    SeedingOptions options;
    options.bubbles = bubbles;
    options.aspect = aspect;
    options.seed = seed;
    Foam foam = seed_foam(options);
    relax(foam, {});
    return foam;
}

SparseLdlt<double> factored(const System& system, int threads = 1) {
    SparseLdlt<double> solver;
    solver.analyze(system.matrix, system.nodes, system.domain);
    EXPECT_TRUE(solver.factor(system.matrix, threads));
    return solver;
}

double largest_entry(const SparseMatrix& matrix) {
    return matrix.coeffs().abs().maxCoeff();
}

// Expects that |A x - b| <= 1e-14 n |A| |x|, where norms are the magnitudes of the largest
// elements.
void expect_solves(const SparseLdlt<double>& solver, const System& system) {
    const Eigen::VectorXd x = solver.solve(system.right_hand_side);
    const Eigen::VectorXd residual =
        system.matrix.selfadjointView<Eigen::Lower>() * x - system.right_hand_side;
    EXPECT_LE(residual.cwiseAbs().maxCoeff(),
              1e-14 * static_cast<double>(x.size()) * largest_entry(system.matrix) *
                  x.cwiseAbs().maxCoeff());
}

// With a shift of 0.1 the condition number is about 1e3. Solutions that differ only by rounding
// then agree to 1e-11.
void expect_agrees_with_dense(const System& system) {
    const SparseMatrix whole = system.matrix.selfadjointView<Eigen::Lower>();
    const Eigen::MatrixXd dense(whole);
    const Eigen::VectorXd expected = dense.partialPivLu().solve(system.right_hand_side);
    const Eigen::VectorXd x = factored(system).solve(system.right_hand_side);
    EXPECT_LT((x - expected).cwiseAbs().maxCoeff(), 1e-11 * expected.cwiseAbs().maxCoeff());
}

TEST(SparseLdlt, AgreesWithADenseSolver) {
    for (const int bubbles : {2, 3, 7, 20, 60, 150}) {
        for (const double aspect : {1.0, 4.0}) {
            SCOPED_TRACE(testing::Message() << bubbles << " bubbles, aspect " << aspect);
            expect_agrees_with_dense(system_of(relaxed_foam(bubbles, aspect), 0.1));
        }
    }
}

TEST(SparseLdlt, SolvesWhereBubblesMeetThemselves) {
    expect_agrees_with_dense(system_of(test::single_bubble(), 0.1));
    expect_agrees_with_dense(system_of(honeycomb(1, 2), 0.1));
    expect_agrees_with_dense(system_of(honeycomb(2, 30), 0.1));
}

// With a shift of 1e-9 the null modes make the matrix nearly singular.
TEST(SparseLdlt, SolvesNearlySingularSystems) {
    for (const double aspect : {1.0, 4.0}) {
        const System system = system_of(relaxed_foam(500, aspect), 1e-9);
        expect_solves(factored(system), system);
    }
}

// 800 bubbles have 4000 rows, enough for several threads to be used.
TEST(SparseLdlt, HasTheSameBitsOnAnyNumberOfThreads) {
    const System system = system_of(relaxed_foam(800), 1e-9);
    const Eigen::VectorXd expected = factored(system, 1).solve(system.right_hand_side);
    for (const int threads : {0, 2, 3, 8, 100}) {
        const Eigen::VectorXd x = factored(system, threads).solve(system.right_hand_side);
        EXPECT_TRUE((x.array() == expected.array()).all()) << threads << " threads";
    }
}

// Each thread has scratch memory of its own, so that the memory depends on the number of threads.
TEST(SparseLdlt, UsesAllThreadsIfTheirNumberIsZero) {
    const SparseLdlt<double> solver = factored(system_of(relaxed_foam(800), 1e-9));
    EXPECT_EQ(solver.memory_bytes(0), solver.memory_bytes(thread_count(0)));
    EXPECT_GT(solver.memory_bytes(2), solver.memory_bytes(1));
}

TEST(SparseLdlt, FactorsNewValuesOfThePattern) {
    Foam foam = relaxed_foam(200);
    SparseLdlt<double> solver = factored(system_of(foam, 0.1));
    for (const JunctionId junction : foam.network.junctions()) {
        foam.positions[junction] *= 1.001;
    }
    foam.domain.width *= 1.001;
    foam.domain.height *= 1.001;
    const System moved = system_of(foam, 0.1);
    ASSERT_TRUE(solver.factor(moved.matrix, 1));
    expect_solves(solver, moved);
}

TEST(SparseLdlt, TakesUpANewPattern) {
    SparseLdlt<double> solver = factored(system_of(relaxed_foam(100), 0.1));
    for (const int bubbles : {30, 200}) {
        const System other = system_of(relaxed_foam(bubbles), 0.1);
        solver.analyze(other.matrix, other.nodes, other.domain);
        ASSERT_TRUE(solver.factor(other.matrix, 1));
        expect_solves(solver, other);
    }
}

// A few T1s change few couplings. The order of elimination is kept.
TEST(SparseLdlt, KeepsTheOrderAfterAFewT1s) {
    Foam foam = relaxed_foam(800);
    SparseLdlt<double> solver = factored(system_of(foam, 0.1));
    const std::size_t before = solver.nonzeros();
    for (const std::size_t film : {100U, 500U, 900U, 1300U}) {
        ASSERT_TRUE(can_flip(foam.network, id_at<FilmId>(film)));
        flip_film(foam, id_at<FilmId>(film));
    }
    const System flipped = system_of(foam, 0.1);
    ASSERT_EQ(solver.analyze(flipped.matrix, flipped.nodes, flipped.domain, {.keeps_order = true}),
              LdltAnalysis::Planned);
    ASSERT_TRUE(solver.factor(flipped.matrix, 1));
    expect_solves(solver, flipped);
    EXPECT_GE(solver.nonzeros(), before);
    EXPECT_LT(static_cast<double>(solver.nonzeros()), 1.1 * static_cast<double>(before));
}

// In another foam of the same number of bubbles, almost every node has other neighbors.
TEST(SparseLdlt, DropsTheOrderIfItDoesNotFit) {
    SparseLdlt<double> solver = factored(system_of(relaxed_foam(300), 0.1));
    const System other = system_of(relaxed_foam(300, 1.0, 2), 0.1);
    solver.analyze(other.matrix, other.nodes, other.domain, {.keeps_order = true});
    EXPECT_EQ(solver.nonzeros(), factored(other).nonzeros());
}

// Makes every seventh bubble vanish, `count` bubbles in total.
void remove_bubbles(Foam& foam, std::size_t count) {
    TopologyCounts counts;
    for (std::size_t bubble = 0; bubble < count; ++bubble) {
        ASSERT_TRUE(collapse(foam, id_at<BubbleId>(7 * bubble), counts));
    }
    compact(foam);
}

TEST(SparseLdlt, KeepsTheOrderAfterAFewT2s) {
    Foam foam = relaxed_foam(800);
    SparseLdlt<double> solver = factored(system_of(foam, 0.1));
    remove_bubbles(foam, 8);
    const System smaller = system_of(foam, 0.1);
    ASSERT_EQ(solver.analyze(smaller.matrix, smaller.nodes, smaller.domain, {.keeps_order = true}),
              LdltAnalysis::Planned);
    ASSERT_TRUE(solver.factor(smaller.matrix, 1));
    expect_solves(solver, smaller);
    const std::size_t with_new_order = factored(smaller).nonzeros();
    EXPECT_NE(solver.nonzeros(), with_new_order);
    EXPECT_LT(static_cast<double>(solver.nonzeros()), 1.05 * static_cast<double>(with_new_order));
}

// All bubbles in one place vanish, so that parts of the dissection become empty.
TEST(SparseLdlt, KeepsTheOrderWherePartsBecomeEmpty) {
    Foam foam = relaxed_foam(800);
    SparseLdlt<double> solver = factored(system_of(foam, 0.1));
    TopologyCounts counts;
    for (const BubbleId bubble : foam.network.bubbles().ids(foam.network.bubble_count())) {
        const Vec2& place = foam.positions[foam.network.tail(foam.network.first(bubble))];
        if ((place - Vec2(10.0, 10.0)).norm() < 4.0) {
            ASSERT_TRUE(collapse(foam, bubble, counts));
        }
    }
    ASSERT_GT(counts.t2, 40);
    compact(foam);
    const System smaller = system_of(foam, 0.1);
    solver.analyze(smaller.matrix, smaller.nodes, smaller.domain, {.keeps_order = true});
    EXPECT_NE(solver.nonzeros(), factored(smaller).nonzeros());
    ASSERT_TRUE(solver.factor(smaller.matrix, 1));
    expect_solves(solver, smaller);
    const Eigen::VectorXd with_one_thread = solver.solve(smaller.right_hand_side, 1);
    ASSERT_TRUE(solver.factor(smaller.matrix, 4));
    EXPECT_EQ(solver.solve(smaller.right_hand_side, 4), with_one_thread);
}

TEST(SparseLdlt, DropsTheOrderIfATenthOfTheBubblesHasVanished) {
    Foam foam = relaxed_foam(800);
    SparseLdlt<double> solver = factored(system_of(foam, 0.1));
    remove_bubbles(foam, 90);
    const System smaller = system_of(foam, 0.1);
    solver.analyze(smaller.matrix, smaller.nodes, smaller.domain, {.keeps_order = true});
    EXPECT_EQ(solver.nonzeros(), factored(smaller).nonzeros());
}

TEST(SparseLdlt, ReportsASingularMatrix) {
    const System system = system_of(relaxed_foam(800), 0.1);
    SparseLdlt<double> solver = factored(system);
    SparseMatrix singular = system.matrix;
    const Eigen::Index zero = system.matrix.rows() / 2;
    for (Eigen::Index column = 0; column < singular.cols(); ++column) {
        for (SparseMatrix::InnerIterator entry(singular, column); entry; ++entry) {
            if (entry.row() == zero || column == zero) {
                entry.valueRef() = 0.0;
            }
        }
    }
    EXPECT_FALSE(solver.factor(singular, 1));
    EXPECT_FALSE(solver.factor(singular, 2));
    ASSERT_TRUE(solver.factor(system.matrix, 2));
    expect_solves(solver, system);
}

TEST(SparseLdlt, ReportsValuesThatAreNotFinite) {
    System system = system_of(relaxed_foam(50), 0.1);
    SparseLdlt<double> solver = factored(system);
    system.matrix.coeffRef(0, 0) = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(solver.factor(system.matrix, 1));
}

TEST(SparseLdlt, RejectsAPlanThatIsTooLarge) {
    const System system = system_of(relaxed_foam(50), 0.1);
    SparseLdlt<double> solver = factored(system);
    EXPECT_GT(solver.memory_bytes(1), sizeof(double) * solver.nonzeros());
    const auto analyze = [&](std::size_t max_bytes) {
        return solver.analyze(system.matrix, system.nodes, system.domain, {.max_bytes = max_bytes});
    };
    EXPECT_EQ(analyze(solver.memory_bytes(1)), LdltAnalysis::Planned);
    EXPECT_EQ(analyze(sizeof(double) * solver.nonzeros() - 1), LdltAnalysis::TooLarge);
    EXPECT_EQ(analyze(0), LdltAnalysis::TooLarge);
}

}  // namespace
}  // namespace foam
