// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/frame.h"

namespace foam {

/// Returns the mean stress of the foam (E11 in core/EQUATIONS.md) as a symmetric matrix. A stress
/// is a force per length. Its unit is the unit of Frame::film_tension divided by the foam unit of
/// length. Tension is positive, pressure negative. The mean is taken over the torus, or over the
/// area of all bubbles of a patch, including lone bubbles.
///
/// On a torus, adding a constant to all pressures subtracts it from xx and yy, and leaves xy and
/// xx - yy unchanged. After an equilibration the mean pressure is 0, so that the trace of the
/// stress is the energy per area. In the equilibrium of a patch the stress is 0, because no force
/// acts on the patch from outside. Returns zero for a patch without bubbles.
Mat2 mean_stress(const Frame& frame);

}  // namespace foam
