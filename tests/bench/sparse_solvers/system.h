// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"
#include "core/sparse/node_graph.h"

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <cstdint>
#include <vector>

namespace foam::bench {

/// A linear system of Newton's method (E3). It is quasi-definite: the pivots of junctions are
/// positive, the pivots of pressures negative.
struct System {
    Domain domain;
    std::vector<SolverNode> nodes;
    Eigen::SparseMatrix<double> lower;  // lower triangle of the regularized Hessian
    Eigen::VectorXd right_side;         // random numbers in [-1, 1)
};

/// Returns the system of a foam in equilibrium.
System relaxed_system(int bubbles, std::uint64_t seed);

/// Returns the system of a raw diagram, but with the positions that its nodes have after `length`
/// times the first step of Newton's method. The step is taken without a limit on the motion of
/// films and without a line search, so that the foam is tangled afterwards: a step of length 1
/// tangles every twentieth junction, one of length 20 nearly half of them. The matrix is from
/// before the step, because a Hessian of tangled films is not quasi-definite. The order of
/// elimination does not depend on the values of the matrix. The entries of the matrix reach 1e5 at
/// the shortest films, and the regularization is 1e-6. Without pivoting, some orders of elimination
/// therefore leave few correct digits in double precision, and give no factor in single precision.
System overshot_system(int bubbles, std::uint64_t seed, double length);

/// Returns the system of a raw diagram, but with the same position for all nodes.
System collapsed_system(int bubbles, std::uint64_t seed);

/// Returns the relative residual |A x - b| / (|A| |x| + |b|) in the maximum norm. The lower
/// triangle of A is given.
double residual(const Eigen::SparseMatrix<double>& lower,
                const Eigen::VectorXd& x,
                const Eigen::VectorXd& b);

/// Returns the lower triangle of a positive definite matrix of the same pattern: each diagonal
/// entry becomes larger than the sum of the absolute values of the other entries of its row.
Eigen::SparseMatrix<double> dominant(const Eigen::SparseMatrix<double>& lower);

}  // namespace foam::bench
