// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"
#include "texgen/preset/loop.h"

namespace foam::texgen {

/// Returns true if images of a loop show the foam displaced or without its shear.
bool is_posed(const LoopOptions& loop);

/// Returns the foam as images show it when the fraction `passed` of the loop has passed. The foam
/// is displaced by this fraction of the drift. In a shear loop the shear is removed, so that images
/// tile. Removing it moves the junctions but not the pressures, so that films keep their
/// curvatures; angles between films then change by up to about the strain, in radians.
Foam posed(Foam foam, const LoopOptions& loop, double passed);

/// Returns the position in the plane to which `posed` moves a point of the foam. `domain` is the
/// domain before the shear is removed.
Vec2 posed(const Vec2& point, const Domain& domain, const LoopOptions& loop, double passed);

}  // namespace foam::texgen
