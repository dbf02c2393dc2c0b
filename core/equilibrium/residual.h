#pragma once

#include "core/equilibrium/unknowns.h"

#include <Eigen/Core>

namespace foam {

/// The function L of E3 for the whole foam.
double lagrangian(const Foam& foam);

/// Gradient of the function L of E3 by the unknowns: minus the force of the films and pressures on
/// each junction, then target area less area of each bubble, then what an outer film lacks of
/// Laplace-Young's law (bulge_energy.h). Zero in equilibrium (E2). The same bits for any number of
/// threads.
Eigen::VectorXd residual(const Foam& foam, const Unknowns& unknowns, int threads = 1);

/// Residuals without units: forces in film tensions, areas in target areas. What an outer film
/// lacks of Laplace-Young's law counts as a force.
struct ResidualNorms {
    double force = 0.0;    // largest
    double area = 0.0;     // largest
    double squares = 0.0;  // sum of all squares; the merit function of the line search
};

ResidualNorms norms(const Foam& foam, const Unknowns& unknowns, const Eigen::VectorXd& residual);

}  // namespace foam
