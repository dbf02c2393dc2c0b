// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"
#include "texgen/preset/loop.h"

namespace foam::texgen {

/// Returns true if images of a loop show the foam moved or without its shear.
bool is_posed(const LoopOptions& loop);

/// Returns the foam as images show it when a fraction of the loop has passed: moved by that
/// fraction of its drift, and on a torus without shear, so that it tiles. If a shear is taken back,
/// junctions ride with the torus and films keep their curvatures; angles are then off by up to half
/// the strain.
Foam posed(Foam foam, const LoopOptions& loop, double passed);

/// Returns the image, in the plane, of a point of that foam before it was posed.
Vec2 posed(const Vec2& point, const Domain& domain, const LoopOptions& loop, double passed);

}  // namespace foam::texgen
