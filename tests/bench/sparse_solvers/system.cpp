// SPDX-License-Identifier: Apache-2.0

#include "tests/bench/sparse_solvers/system.h"

#include "core/equilibrium/equilibrate.h"
#include "core/equilibrium/hessian.h"
#include "core/equilibrium/linear_solver.h"
#include "core/equilibrium/moves.h"
#include "core/equilibrium/newton_system.h"
#include "core/equilibrium/residual.h"
#include "core/foam/random.h"
#include "core/foam/seeding.h"

#include <cmath>
#include <stdexcept>
#include <utility>

namespace foam::bench {

namespace {

constexpr double kRegularization = 1e-6;  // as for a factor in single precision

Eigen::SparseMatrix<double> regularized_hessian(const Foam& foam, const Unknowns& unknowns) {
    Hessian hessian(foam.network, unknowns);
    hessian.evaluate(foam);
    for (int row = 0; row < unknowns.size(); ++row) {
        double& diagonal = hessian.diagonal(row);
        diagonal += row < unknowns.first_pressure_row()
                        ? kRegularization * foam.film_tension
                        : -kRegularization * (std::abs(diagonal) + 1e-12);
    }
    return hessian.matrix();
}

Eigen::VectorXd random_vector(Eigen::Index size) {
    Random random(1);
    return Eigen::VectorXd::NullaryExpr(size, [&] { return 2.0 * random.uniform() - 1.0; });
}

System system_of(const Foam& foam) {
    const Unknowns unknowns = all_unknowns(foam.network);
    return {foam.domain,
            solver_nodes(foam, unknowns),
            regularized_hessian(foam, unknowns),
            random_vector(unknowns.size())};
}

Foam raw_diagram(int bubbles, std::uint64_t seed) {
    return seed_foam({.bubbles = bubbles, .seed = seed});
}

// Returns the sum of the absolute values of the off-diagonal entries in each row of a symmetric
// matrix.
Eigen::VectorXd off_diagonal_sums(const Eigen::SparseMatrix<double>& lower) {
    Eigen::VectorXd sums = Eigen::VectorXd::Zero(lower.rows());
    for (Eigen::Index col = 0; col < lower.cols(); ++col) {
        for (Eigen::SparseMatrix<double>::InnerIterator it(lower, col); it; ++it) {
            if (it.row() != col) {
                sums[it.row()] += std::abs(it.value());
                sums[col] += std::abs(it.value());
            }
        }
    }
    return sums;
}

}  // namespace

System relaxed_system(int bubbles, std::uint64_t seed) {
    Foam foam = raw_diagram(bubbles, seed);
    if (!equilibrate(foam, {}).converged()) {
        throw std::runtime_error("no equilibrium");
    }
    return system_of(foam);
}

System overshot_system(int bubbles, std::uint64_t seed, double length) {
    Foam foam = raw_diagram(bubbles, seed);
    System system = system_of(foam);
    const Unknowns unknowns = all_unknowns(foam.network);
    NewtonSystem newton;
    newton.start(foam, unknowns, 1);
    newton.raise_precision(foam);
    const Eigen::VectorXd step = newton.step(foam, residual(foam, unknowns));
    if (step.isZero()) {
        throw std::runtime_error("no step of Newton's method");
    }
    set_state(foam, unknowns, state_of(foam, unknowns), step, length);
    wrap(foam, unknowns);
    system.nodes = solver_nodes(foam, unknowns);
    return system;
}

System collapsed_system(int bubbles, std::uint64_t seed) {
    System system = system_of(raw_diagram(bubbles, seed));
    for (SolverNode& node : system.nodes) {
        node.position.setZero();
    }
    return system;
}

double residual(const Eigen::SparseMatrix<double>& lower,
                const Eigen::VectorXd& x,
                const Eigen::VectorXd& b) {
    const Eigen::VectorXd error = lower.selfadjointView<Eigen::Lower>() * x - b;
    const auto largest = [](const Eigen::VectorXd& v) { return v.lpNorm<Eigen::Infinity>(); };
    const Eigen::VectorXd sums = off_diagonal_sums(lower) + lower.diagonal().cwiseAbs();
    return largest(error) / (largest(sums) * largest(x) + largest(b));
}

Eigen::SparseMatrix<double> dominant(const Eigen::SparseMatrix<double>& lower) {
    Eigen::SparseMatrix<double> matrix = lower;
    matrix.diagonal() = 1.1 * (off_diagonal_sums(lower).array() + 1e-3);
    return matrix;
}

}  // namespace foam::bench
