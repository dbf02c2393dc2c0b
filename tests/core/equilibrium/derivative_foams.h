// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/equilibrium/unknowns.h"

#include <Eigen/Core>

#include <vector>

namespace foam::test {

/// Returns foams for tests of derivatives. Some are tori so small that bubbles are their own
/// neighbors and that several films separate the same two bubbles. Pressures are low in some foams;
/// in others they are so high that films are at the limit of their half angle. Film tensions differ
/// from 1 in most foams. No film is shorter than 0.05, so that differences over steps of 1e-5 are
/// accurate.
std::vector<Foam> derivative_foams();

/// Returns patches with random pressures, whose outer films have half angles of up to 143 degrees
/// in magnitude.
std::vector<Foam> derivative_patches();

/// Returns the Hessian of E3 with respect to the unknowns, with both triangles.
Eigen::MatrixXd full_hessian(const Foam& foam, const Unknowns& unknowns);

/// Returns the foam with `by` added to the unknown of the given row.
Foam shifted(Foam foam, const Unknowns& unknowns, int row, double by);

}  // namespace foam::test
