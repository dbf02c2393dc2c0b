// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"
#include "core/foam/topology_thresholds.h"

namespace foam {

/// A push around a center (E9): junctions within the radius R move by (1 - r²/R²)² times the whole
/// displacement, where r is their distance from the center. The center moves with the push.
/// Precondition: the radius is positive and at most half of the shorter side of the torus.
struct Displacement {
    Vec2 center{0.0, 0.0};  // foam units, anywhere in the plane
    double radius = 1.0;
    Vec2 by{0.0, 0.0};
};

/// Moves the junctions in steps so small that no films cross. After each step, the T1 rule (E7) is
/// applied to short films that have lost more than half of their length. Leaves the foam far from
/// equilibrium. Returns the number of T1s.
int displace(Foam& foam, const Displacement& displacement, const TopologyThresholds& thresholds);

}  // namespace foam
