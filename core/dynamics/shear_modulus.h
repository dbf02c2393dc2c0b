// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/frame.h"

#include <optional>

namespace foam {

/// Returns the shear modulus of a torus (E11 in core/EQUATIONS.md): the derivative of the shear
/// stress with respect to the strain, in equilibrium and without T1s. Its unit is the unit of the
/// film tension divided by the unit of length. Two copies of the foam are sheared by plus and minus
/// 1e-4 and brought to equilibrium by Newton's method. The shear modulus is computed from their
/// stresses. Its relative error is about 1e-7, more if films are nearly short enough for a T1.
/// `threads` has the same meaning as in parallel_for. The result has the same bits for any number
/// of threads.
///
/// Returns nullopt in the plane, if the errors of the foam (EquilibriumErrors) are not below 1e-3,
/// or if Newton's method does not converge.
std::optional<double> shear_modulus(const Foam& foam, int threads = 0);

/// Returns the shear modulus of a frame in the same way.
std::optional<double> shear_modulus(const Frame& frame, int threads = 0);

}  // namespace foam
