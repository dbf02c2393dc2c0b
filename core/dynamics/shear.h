// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"

namespace foam {

/// Applies simple shear along x to the whole foam and its torus: every point moves to the right by
/// the strain times its y coordinate. Areas are unchanged. The foam is left out of equilibrium by
/// the strain. Reduces the lattice if its shear exceeds half a width.
void shear(Foam& foam, double strain);

/// Changes the shear of the torus by whole widths into [-width/2, width/2]. This describes the same
/// lattice by other periods: nothing moves, only lattice offsets change.
void reduce_lattice(Foam& foam);

}  // namespace foam
