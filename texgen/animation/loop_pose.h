#pragma once

#include "core/foam/foam.h"
#include "texgen/preset/loop.h"

namespace foam::texgen {

/// Whether images of a loop show the foam otherwise than it is.
bool is_posed(const LoopOptions& loop);

/// The foam as images of a loop show it, of which a part has passed: travelled that part of its
/// drift, and on a torus without shear, so that it tiles. Where a shear is taken back, junctions
/// ride with the torus and films keep their curvatures; angles are then off by up to half the
/// strain.
Foam posed(Foam foam, const LoopOptions& loop, double passed);

/// Where a place of that foam, which is on a torus as given, is then; in the plane.
Vec2 posed(const Vec2& place, const Domain& domain, const LoopOptions& loop, double passed);

}  // namespace foam::texgen
