// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/equilibrium/unknowns.h"

#include <Eigen/Core>

namespace foam {

/// Returns the gradient of the function L of E3 with respect to the unknowns, which is zero in
/// equilibrium (E2). The two rows of a junction are minus the force of films and pressures on it.
/// The row of a bubble is its target area minus its area. The row of an outer film is the
/// derivative with respect to its half angle (bulge_energy.h). `threads` has the same meaning as in
/// parallel_for; the result has the same bits for any number of threads.
Eigen::VectorXd residual(const Foam& foam, const Unknowns& unknowns, int threads = 1);

/// Dimensionless norms of a residual. Forces are in units of the film tension, area errors in units
/// of the target area. The error of Laplace-Young's law at an outer film counts as a force in
/// `force` and `squares`. If an entry of the residual is NaN, the norms that depend on this entry
/// are NaN.
struct ResidualNorms {
    double force = 0.0;    // largest force on a junction, or largest error at an outer film
    double area = 0.0;     // largest magnitude of an area error
    double squares = 0.0;  // sum of all squares; the merit function of the line search
};

/// Returns the norms of a residual. Precondition: it is the residual of the foam in its present
/// state, for these unknowns.
ResidualNorms norms(const Foam& foam, const Unknowns& unknowns, const Eigen::VectorXd& residual);

}  // namespace foam
