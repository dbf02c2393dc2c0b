#pragma once

#include "core/foam/topology_thresholds.h"
#include "core/foam/foam.h"

namespace foam {

/// A push at a place: junctions within the radius move along, those at its centre by the whole way
/// and those at its edge not at all, as (1 - r²/R²)² says, and the centre moves with them. The
/// radius is above 0 and at most half of the torus' shorter side.
struct Displacement {
    Vec2 center{0.0, 0.0};  // foam units, anywhere in the plane
    double radius = 1.0;
    Vec2 by{0.0, 0.0};
};

/// Moves the junctions, in steps so small that no films cross. After each, films that have become
/// much shorter flip where their flipped state pulls apart (E7). The foam is left far from
/// equilibrium. Returns the number of T1.
int displace(Foam& foam, const Displacement& displacement, const TopologyThresholds& thresholds);

}  // namespace foam
