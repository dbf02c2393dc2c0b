// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"

namespace foam {

/// Applies simple shear along x to the whole foam and its torus: every point moves to the right by
/// the strain times its y coordinate. The areas within the chords of the bubbles are unchanged. The
/// foam is not in equilibrium afterwards. Finally, a whole multiple of the width of the torus is
/// subtracted from Domain::shear, so that the magnitude of Domain::shear is at most half of the
/// width. The new value describes the same torus; no junction moves (reduce_lattice in
/// core/foam/lattice.h).
/// Precondition: the domain is a torus.
void shear(Foam& foam, double strain);

}  // namespace foam
