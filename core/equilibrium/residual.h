#pragma once

#include "core/equilibrium/unknowns.h"

#include <Eigen/Core>

namespace foam {

/// Returns the function L of E3 for the whole foam.
double lagrangian(const Foam& foam);

/// Returns the gradient of the function L of E3 by the unknowns: minus the force of films and
/// pressures on each junction, then target area minus area of each bubble, then the derivative by
/// the half angle of each outer film (bulge_energy.h). It is zero in equilibrium (E2). `threads` as
/// in parallel_for; the bits are the same for any number.
Eigen::VectorXd residual(const Foam& foam, const Unknowns& unknowns, int threads = 1);

/// Norms of a residual without units: forces in film tensions, areas in target areas. The error of
/// Laplace-Young's law at an outer film counts as a force.
struct ResidualNorms {
    double force = 0.0;    // largest
    double area = 0.0;     // largest
    double squares = 0.0;  // sum of all squares; the merit function of the line search
};

ResidualNorms norms(const Foam& foam, const Unknowns& unknowns, const Eigen::VectorXd& residual);

}  // namespace foam
