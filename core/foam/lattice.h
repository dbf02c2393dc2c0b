// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"

namespace foam {

/// Adds a whole multiple of the width of a torus to Domain::shear, so that the magnitude of the
/// shear is at most half of the width. The torus remains the same, because its period (shear,
/// height) changes by a multiple of its other period, (width, 0). No junction moves; only lattice
/// offsets change. In the plane, nothing changes.
void reduce_lattice(Foam& foam);

}  // namespace foam
