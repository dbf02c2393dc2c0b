#pragma once

#include "core/foam/foam.h"
#include "core/foam/topology_thresholds.h"

namespace foam {

/// A push around a center: junctions within the radius R move by (1 - r²/R²)² times the whole
/// displacement, where r is their distance from the center, which moves along. The radius is above
/// 0 and at most half of the shorter side of the torus.
struct Displacement {
    Vec2 center{0.0, 0.0};  // foam units, anywhere in the plane
    double radius = 1.0;
    Vec2 by{0.0, 0.0};
};

/// Moves the junctions, in steps so small that no films cross. After each step, films that have
/// become much shorter flip if their flipped state stays open (E7). The foam is left far from
/// equilibrium. Returns the number of T1s.
int displace(Foam& foam, const Displacement& displacement, const TopologyThresholds& thresholds);

}  // namespace foam
