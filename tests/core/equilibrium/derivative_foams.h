// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/equilibrium/unknowns.h"

#include <Eigen/Core>

#include <vector>

namespace foam::test {

/// Foams to check derivatives on: ordinary ones, and tori so small that bubbles meet themselves and
/// films stand between the same bubbles many times; gentle pressures, and such as hold films at
/// their largest half angle; tension other than 1. No film is shorter than 0.05, so that
/// differences over steps of 1e-5 make sense.
std::vector<Foam> derivative_foams();

/// Patches with random pressures whose outer films have half angles up to 143 degrees either way.
std::vector<Foam> derivative_patches();

/// The Hessian of E3 by all the unknowns, both triangles.
Eigen::MatrixXd full_hessian(const Foam& foam, const Unknowns& unknowns);

/// The foam with one unknown changed.
Foam shifted(Foam foam, const Unknowns& unknowns, int row, double by);

}  // namespace foam::test
