// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"

namespace foam {

/// Applies simple shear along x to the whole foam and its torus: every point moves to the right by
/// the strain times its y coordinate. The areas within the chords of the bubbles are unchanged. The
/// foam is not in equilibrium afterwards. Calls reduce_lattice.
void shear(Foam& foam, double strain);

/// Adds a whole multiple of the width to Domain::shear (how far the cell above is shifted to the
/// right), so that its magnitude is at most half of the width. The changed periods describe the
/// same lattice: no junction moves, only lattice offsets change.
void reduce_lattice(Foam& foam);

}  // namespace foam
