// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"
#include "core/foam/topology_thresholds.h"

namespace foam {

/// A push around a center (E9). A junction at the distance r from the center moves by (1 - r²/R²)²
/// times the displacement `by` if r is less than the radius R. Other junctions move only in
/// T1s. The push is made in small steps, and the center moves with each step. Precondition: the
/// radius is positive and, on a torus, at most half of the shorter side of the torus.
struct Displacement {
    Vec2 center{0.0, 0.0};  // foam units, anywhere in the plane
    double radius = 1.0;    // foam units
    Vec2 by{0.0, 0.0};      // displacement of the center, foam units
};

/// Moves the junctions in steps so small that a step does not fold the plane. After each step, the
/// T1 rule (E7) is applied to short films that have lost more than half of their length. The length
/// of a film is compared with its length at the start or, if the film has flipped, after its last
/// flip. The T1 distance for this rule is at least 0.25. Leaves the foam far from equilibrium.
/// Returns the number of T1s.
int displace(Foam& foam, const Displacement& displacement, const TopologyThresholds& thresholds);

}  // namespace foam
