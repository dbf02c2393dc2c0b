// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"

namespace foam {

/// Applies simple shear along x to the whole foam and its torus: every point moves to the right by
/// the strain times its y coordinate. Areas are unchanged. The foam is not in equilibrium
/// afterwards. Calls reduce_lattice.
void shear(Foam& foam, double strain);

/// Changes the shear of the torus by whole widths into [-width/2, width/2]. The new periods
/// describe the same lattice: no junction moves, only lattice offsets change.
void reduce_lattice(Foam& foam);

}  // namespace foam
