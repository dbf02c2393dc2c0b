#pragma once

#include "core/foam/foam.h"
#include "texgen/preset/loop.h"

namespace foam::texgen {

/// The foam as images of a loop show it, of which a part has passed: travelled that part of its
/// drift, and on a torus without shear, so that it tiles. Where a shear is taken back, junctions
/// ride with the torus and films keep their curvatures; angles are then off by up to half the
/// strain.
Foam posed(Foam foam, const LoopOptions& loop, double passed);

/// Where a place of that foam, which is on a torus as given, is then; in the plane.
Vec2 posed(const Vec2& place, const Torus& torus, const LoopOptions& loop, double passed);

/// The frame of the simulation that a frame of the animation shows: of a pingpong of `count` frames
/// it comes back from the middle, of all else it is the same.
int shown_frame(int number, const LoopOptions& loop, int count);

}  // namespace foam::texgen
